#include "app/SceneProbe.h"

#include "analysis/ReceiverPixels.h"
#include "app/Cancellation.h"
#include "app/FrameReads.h"
#include "app/Reports.h"
#include "filters/core/Error.h"

namespace umbra {
namespace {

std::string textOf(Pixel pixel) {
  return std::to_string(pixel.x) + "," + std::to_string(pixel.y);
}

SurfacePoint surfaceOf(HeadlessFrame& frame, const Session& session, Pixel pixel) {
  if (pixel.x >= session.width || pixel.y >= session.height)
    throw Error(ErrorKind::BadCommandLine,
                "--pixel: " + textOf(pixel) + " is outside the picture of " +
                    std::to_string(session.width) + "x" + std::to_string(session.height) +
                    " pixels, which count from 0");
  const std::optional<SurfacePoint> surface = frame.surfaceAt(pixel.x, pixel.y);
  if (!surface)
    throw Error(
        ErrorKind::BadCommandLine,
        "--pixel: " + textOf(pixel) + " shows no surface; choose one on an object, or 'worst'");
  const bool inside = surface->u >= 0 && surface->u <= 1 && surface->v >= 0 && surface->v <= 1;
  if (!inside)
    throw Error(ErrorKind::BadCommandLine,
                "--pixel: " + textOf(pixel) +
                    " lies outside the shadow map; choose one inside, or 'worst'");
  return *surface;
}

}  // namespace

std::shared_ptr<Technique> suspectOf(const std::vector<std::shared_ptr<Technique>>& chosen) {
  std::shared_ptr<Technique> bound;
  for (const auto& technique : chosen) {
    if (technique->info().id == "vsm") return technique;
    if (!bound && technique->info().upperBound) bound = technique;
  }
  return bound ? bound : chosen.front();
}

SceneProbe probeScene(HeadlessFrame& frame, const Session& session,
                      const std::vector<std::shared_ptr<Technique>>& techniques, Pixel pixel) {
  std::vector<SurfacePoint> surfaces;
  for (const auto& technique : techniques) {
    throwIfCancelled();
    frame.render(*technique, ViewMode::Shaded);
    surfaces.push_back(surfaceOf(frame, session, pixel));
  }
  const SurfacePoint& surface = surfaces.front();
  ProbeRequest request = requestAt(frame, session.frame, surface);
  request.receiver = session.receiver.value_or(surface.receiver);
  const DepthMap& first = frame.depthMap(0);
  for (const auto& technique : techniques) {
    technique->adapt(first);
    request.techniques.push_back(technique);
  }
  SceneProbe result{takeProbe(request), pixel, surface};
  // A receiver set by hand is not the one that the frame was shaded with.
  if (!session.receiver)
    for (std::size_t i = 0; i < techniques.size(); ++i)
      result.probe.techniques[i].gpu = surfaces[i].visibility;
  return result;
}

Pixel worstBleeding(HeadlessFrame& frame, const Technique& technique) {
  frame.render(technique, ViewMode::Shaded);
  if (const std::optional<Pixel> plain = frame.plainestBleeding()) return *plain;
  const Image<float> surfaces = frame.surfaces(), reference = frame.reference();
  std::optional<Pixel> worst;
  float largest = 0.0f;
  for (int y = 0; y < surfaces.height(); ++y)
    for (int x = 0; x < surfaces.width(); ++x) {
      if (!receivesShadow(surfaces.pixel(x, y))) continue;
      const float error = surfaces(x, y, 3) - reference(x, y);
      if (worst && error <= largest) continue;
      worst = Pixel{x, y};
      largest = error;
    }
  if (!worst)
    throw Error(ErrorKind::WorkFailed,
                "no pixel of the picture faces the light inside its map; move light or camera");
  return *worst;
}

Json sceneProbeToJson(const SceneProbe& probe, const DepthMap& map, const std::string& name,
                      ReadFilter filter, int bins, int samples) {
  Json object = probeToJson(probe.probe, map, {name, bins, samples});
  const SurfacePoint& surface = probe.surface;
  object["pixel"] = {probe.pixel.x, probe.pixel.y};
  object["world"] = {surface.world.x(), surface.world.y(), surface.world.z()};
  object["uv"] = {surface.u, surface.v};
  object["cascade"] = surface.cascade;
  if (surface.nextCascade > 0.0) object["nextCascade"] = surface.nextCascade;
  object["filter"] = nameOf(filter);
  if (filter != ReadFilter::Point && filter != ReadFilter::Bilinear)
    object["footprint"] = {{"x", surface.footprint.x},
                           {"y", surface.footprint.y},
                           {"probes", surface.footprint.probes}};
  return object;
}

}  // namespace umbra
