// Implements BenchFrames by EGL windows: one for our frames, and one for each way of VTK's.
#pragma once

#include <vtkSmartPointer.h>

#include "app/display/Display.h"
#include "app/display/VtkMessages.h"
#include "filters/gpu/bench/MovingScene.h"

namespace umbra {

class RendererBench final : public BenchFrames {
 public:
  RendererBench(const BenchView& view, int mapSize, std::optional<CostClock> clock,
                vtkSmartPointer<VtkMessages> messages);

  std::string renderer() override;
  CostClock clock() const override { return frames_.clock(); }
  void show(const FrameSettings& settings, const Technique& technique) override;
  double draw(Motion motion) override;
  std::vector<PassTime> drawPasses() override;
  double drawBaseline(Baseline baseline, Motion motion) override;
  double bytesUsed(const FrameSettings& settings, const Technique& technique) override;

 private:
  vtkSmartPointer<VtkMessages> messages_;
  TechniqueFrames frames_;
  VtkFrames noShadow_, shadowMapPass_;
};

}  // namespace umbra
