#include "app/display/RendererBench.h"

#include <utility>

#include "filters/gpu/bench/FrameCosts.h"

namespace umbra {

RendererBench::RendererBench(const BenchView& view, int mapSize, std::optional<CostClock> clock,
                             vtkSmartPointer<VtkMessages> messages)
    : messages_(std::move(messages)),
      frames_(view, clock),
      noShadow_(view, Baseline::NoShadow, mapSize, clock),
      shadowMapPass_(view, Baseline::VtkShadowMapPass, mapSize, clock) {
  messages_->throwFirstError();
}

std::string RendererBench::renderer() {
  frames_.makeCurrent();
  return nameOfRenderer();
}

void RendererBench::show(const FrameSettings& settings, const Technique& technique) {
  frames_.show(settings, technique);
  messages_->throwFirstError();
}

double RendererBench::draw(Motion motion) {
  const double milliseconds = frames_.draw(motion);
  messages_->throwFirstError();
  return milliseconds;
}

std::vector<PassTime> RendererBench::drawPasses() {
  std::vector<PassTime> times = frames_.drawPasses();
  messages_->throwFirstError();
  return times;
}

double RendererBench::drawBaseline(Baseline baseline, Motion motion) {
  VtkFrames& frames = baseline == Baseline::NoShadow ? noShadow_ : shadowMapPass_;
  const double milliseconds = frames.draw(motion);
  messages_->throwFirstError();
  return milliseconds;
}

double RendererBench::bytesUsed(const FrameSettings& settings, const Technique& technique) {
  return bytesUsedPerTexel(settings, technique);
}

}  // namespace umbra
