#include "app/display/RendererFrame.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "analysis/errors/WorstPixel.h"
#include "filters/gpu/HeadlessWindow.h"
#include "filters/gpu/bench/FrameCosts.h"

namespace umbra {

RendererFrame::RendererFrame(std::shared_ptr<const Scene> scene, const Session& session,
                             vtkSmartPointer<VtkMessages> messages)
    : messages_(std::move(messages)),
      window_(makeHeadlessWindow(session.width, session.height)),
      renderer_(*window_) {
  show(std::move(scene), session);
}

void RendererFrame::show(std::shared_ptr<const Scene> scene, const Session& session) {
  const int* size = window_->GetSize();
  if (size[0] != session.width || size[1] != session.height)
    window_->SetSize(session.width, session.height);
  if (scene != scene_) renderer_.setScene(scene);
  scene_ = std::move(scene);
  renderer_.setLight(session.light.value_or(scene_->light));
  renderer_.setCamera(session.camera.value_or(scene_->camera));
  saidSamples_ = saidSamples_ && session.frame.map.samples == settings_.map.samples;
  settings_ = session.frame;
}

void RendererFrame::render(const Technique& technique, ViewMode view) {
  settings_.view = view;
  renderer_.setFrame(settings_);
  renderer_.setTechnique(technique);
  renderer_.render();
  messages_->throwFirstError();
  if (saidSamples_ || renderer_.samples() >= settings_.map.samples) return;
  spdlog::warn("--msaa: {} depths a texel, the driver does not offer {}", renderer_.samples(),
               settings_.map.samples);
  saidSamples_ = true;
}

Image<std::uint8_t> RendererFrame::colour() {
  return checked(renderer_.colour());
}
SurfaceImage RendererFrame::surfaces() {
  return checked(renderer_.surfaces());
}
std::shared_ptr<const FrameSnapshot> RendererFrame::snapshot() {
  return checked(renderer_.snapshot());
}
Image<float> RendererFrame::reference() {
  return checked(renderer_.reference());
}

std::optional<SurfacePoint> RendererFrame::surfaceAt(int x, int y) {
  return checked(renderer_.surfaceAt(x, y));
}

const DepthMap& RendererFrame::depthMap(int cascade) {
  const DepthMap& map = renderer_.depthMap(cascade);
  messages_->throwFirstError();
  return map;
}

Image<float> RendererFrame::channels(BakeStage stage) {
  return checked(renderer_.channels(stage));
}

std::optional<Pixel> RendererFrame::plainestBleeding() {
  const SurfaceImage points = surfaces();
  const auto worst = worstBleeding(points, reference());
  if (!worst) return std::nullopt;
  return Pixel{worst->x, worst->y};
}

TechniqueCost RendererFrame::cost(const Technique& technique) {
  window_->MakeCurrent();
  settings_.view = ViewMode::Shaded;
  renderer_.setFrame(settings_);
  renderer_.setTechnique(technique);
  const FrameCosts cost = costOfFrames(renderer_);
  messages_->throwFirstError();
  return {cost.bakeMs, cost.shadeMs, bytesStoredPerTexel(technique, settings_.map.format),
          bytesUsedPerTexel(settings_, technique)};
}

}  // namespace umbra
