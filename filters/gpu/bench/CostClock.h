// Measures what drawing costs, on the clock that fits the renderer.
#pragma once

#include <functional>
#include <string>

#include "filters/gpu/bench/BenchView.h"
#include "filters/gpu/gl/Handle.h"

namespace umbra {

// These need a current context.
std::string nameOfRenderer();  // GL_RENDERER: "llvmpipe (LLVM 15.0.6, 256 bits)"
bool drawsInSoftware();        // whether the processor does the GPU's work
inline CostClock fittingClock() {
  return drawsInSoftware() ? CostClock::Processor : CostClock::Gpu;
}

class CostMeter {
 public:
  explicit CostMeter(CostClock clock) : clock_(clock) {}

  // The milliseconds that `draw` costs, until all that it asked for is drawn.
  double millisecondsOf(const std::function<void()>& draw);

 private:
  CostClock clock_;
  gl::QueryHandle begin_, end_;
};

}  // namespace umbra
