// Implements HeadlessFrame by the shadow renderer and an EGL window.
#pragma once

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "app/display/Display.h"
#include "app/display/VtkMessages.h"
#include "filters/gpu/ShadowRenderer.h"

namespace umbra {

class RendererFrame final : public HeadlessFrame {
 public:
  RendererFrame(std::shared_ptr<const Scene> scene, const Session& session,
                vtkSmartPointer<VtkMessages> messages);

  void show(std::shared_ptr<const Scene> scene, const Session& session) override;
  void render(const Technique& technique, ViewMode view) override;
  Image<std::uint8_t> colour() override;
  SurfaceImage surfaces() override;
  std::shared_ptr<const FrameSnapshot> snapshot() override;
  std::optional<SurfacePoint> surfaceAt(int x, int y) override;
  Image<float> reference() override;
  const DepthMap& depthMap(int cascade = 0) override;
  Image<float> channels(BakeStage stage) override;
  std::optional<Pixel> plainestBleeding() override;
  TechniqueCost cost(const Technique& technique) override;

 private:
  // The result of a read-back, unless VTK reported an error meanwhile.
  template <class T>
  T checked(T result) {
    messages_->throwFirstError();
    return result;
  }

  vtkSmartPointer<VtkMessages> messages_;
  vtkSmartPointer<vtkRenderWindow> window_;
  ShadowRenderer renderer_;
  std::shared_ptr<const Scene> scene_;
  FrameSettings settings_;
  bool saidSamples_ = false;  // whether the log says that the driver gives fewer samples
};

}  // namespace umbra
