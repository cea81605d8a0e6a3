// Draws a scene with filtered shadows into a VTK window, and hands out what each stage made. It
// redoes only what changed: moving the camera bakes nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/frame/FrameSnapshot.h"
#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Image.h"
#include "filters/core/maps/Region.h"
#include "filters/core/maps/SurfaceImage.h"
#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"
#include "filters/gpu/BakeStage.h"
#include "filters/gpu/Baked.h"
#include "filters/gpu/SplitPace.h"
#include "filters/gpu/gl/PassClock.h"

class vtkRenderer;
class vtkRenderWindow;

namespace umbra {

// The time of one pass of the last frame; passes that had nothing to do are absent.
struct PassTime {
  std::string pass;  // "depth", "splits", "encode", "prefilter", "levels", "sums", "shade",
                     // "view"
  double milliseconds = 0.0;
};

class ShadowRenderer {
 public:
  // `window` must outlive the renderer. Adds a vtkRenderer to it.
  explicit ShadowRenderer(vtkRenderWindow& window);
  ~ShadowRenderer();
  ShadowRenderer(const ShadowRenderer&) = delete;
  ShadowRenderer& operator=(const ShadowRenderer&) = delete;

  void setScene(std::shared_ptr<const Scene> scene);  // keeps light and camera
  void setLight(const Light& light);
  void setCamera(const Camera& camera);
  void setFrame(const FrameSettings& settings);
  void setTechnique(const Technique& technique);  // copies it, adapts the copy to each depth map
  // Sets how splits that follow the map (Technique::adaptedSplitCount) come to rest. The default is
  // Converged.
  void setSplitPace(SplitPace pace);

  // The camera, which an interactor may have moved.
  Camera camera() const;
  // The renderer, for interactors and for drawing over the scene. Actors that others add cast no
  // shadow.
  vtkRenderer& renderer();
  LightFrame lightFrame() const;  // the whole light's
  // The cascades of the last frame: the whole light's frame alone, or one for each part of the
  // view.
  const std::vector<Cascade>& cascades() const;
  // What the last frame was baked into: equal while maps and channels are the same.
  Baked baked() const;
  // Samples a texel in the last bake; the driver may give fewer than were asked for.
  int samples() const;

  // Whether another frame would move splits.
  bool splitsMoving() const;
  // The adapted splits of the last frame's technique, ascending. setAdaptedSplits makes a copy of
  // the technique agree with the picture. Empty where the splits do not follow the map.
  std::vector<double> adaptedSplits() const;

  // Bakes what has changed and draws. Throws NoOpenGL or WorkFailed.
  void render();

  // These read back the last frame and its bake. Pixel (0, 0) is the top-left one.
  Image<std::uint8_t> colour();  // RGB, as shown
  SurfaceImage surfaces();
  // All that the last frame left. It is made once for each frame, when it is first asked for. Where
  // the last frame of `beside` has the same depth maps, the snapshot shares them with that
  // renderer, so that they are read back once for both.
  std::shared_ptr<const FrameSnapshot> snapshot(ShadowRenderer* beside = nullptr);
  // One pixel's, with its place in the world; none outside the picture and without a surface.
  std::optional<SurfacePoint> surfaceAt(int x, int y);
  // Exact percentage-closer filtering of every pixel of the last frame over the region that the
  // frame's read averages; 1 where there is no surface. One channel.
  Image<float> reference();
  // The depths of one cascade's map. They are read back once per bake and never changed: whoever
  // keeps them has this bake's, and two that are the same object are of the same bake.
  std::shared_ptr<const DepthMap> sharedDepthMap(int cascade = 0);
  // The same, for as long as nothing is rendered.
  const DepthMap& depthMap(int cascade = 0) { return *sharedDepthMap(cascade); }
  // The technique's channels of one cascade, interleaved in the technique's order.
  Image<float> channels(BakeStage stage, int cascade = 0);

  // On which clock passes are timed. The default is Gpu.
  void setPassClock(PassClock clock);
  std::vector<PassTime> passTimes() const;
  // The next frame bakes everything anew, although nothing has changed.
  void forgetBake();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace umbra
