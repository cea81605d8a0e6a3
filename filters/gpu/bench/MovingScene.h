// A scene whose frames are drawn again and again to measure them.
#pragma once

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <optional>
#include <vector>

#include "filters/gpu/ShadowRenderer.h"
#include "filters/gpu/bench/BenchView.h"
#include "filters/gpu/bench/CostClock.h"

class vtkSequencePass;

namespace umbra {

// The window with the scene, the motion and the clock. Each has an OpenGL context of its own.
class MovingScene {
 public:
  MovingScene(const BenchView& view, std::optional<CostClock> clock);
  ~MovingScene() { makeCurrent(); }  // the meter's clocks are freed in their own context
  MovingScene(const MovingScene&) = delete;
  MovingScene& operator=(const MovingScene&) = delete;

  CostClock clock() const { return clock_; }
  void makeCurrent() { window_->MakeCurrent(); }

 protected:
  // Moves there and back again in turn.
  void move(Motion motion);
  double millisecondsOf(const std::function<void()>& draw) { return meter_.millisecondsOf(draw); }
  vtkRenderWindow& window() { return *window_; }
  ShadowRenderer& renderer() { return renderer_; }

 private:
  vtkSmartPointer<vtkRenderWindow> window_;
  ShadowRenderer renderer_;
  Light light_;
  double side_ = 1.0;
  CostClock clock_;
  CostMeter meter_;
};

// Frames with our shadows.
class TechniqueFrames : public MovingScene {
 public:
  // Without a clock, takes the one that fits the renderer.
  explicit TechniqueFrames(const BenchView& view, std::optional<CostClock> clock = {})
      : MovingScene(view, clock) {}

  // Frames from now on have these settings. Draws one, so that shaders are compiled and textures
  // have their sizes.
  void show(const FrameSettings& settings, const Technique& technique);
  // Draws one frame after a motion and returns its milliseconds. After the light's, splits that
  // follow the map move as they do in a window, two in a frame; after the camera's they are at
  // rest.
  double draw(Motion motion);
  // Draws one frame after the light has moved and returns the milliseconds of its passes. On the
  // processor's clock it waits after each pass.
  std::vector<PassTime> drawPasses();

 private:
  void setPace(SplitPace pace);

  bool followsMap_ = false;  // whether the technique's splits do
  SplitPace pace_ = SplitPace::Converged;
};

// Frames by VTK's own passes.
class VtkFrames : public MovingScene {
 public:
  // `mapSize` counts the texels a side of VTK's shadow map.
  VtkFrames(const BenchView& view, Baseline baseline, int mapSize,
            std::optional<CostClock> clock = {});
  ~VtkFrames();

  double draw(Motion motion);

 private:
  vtkSmartPointer<vtkSequencePass> passes_;
};

}  // namespace umbra
