// Draws cases and baselines in turns, round after round, until their medians are known.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/cost/CostRatios.h"
#include "app/display/Display.h"
#include "app/frames/Drawings.h"

namespace umbra {

// How many rounds are measured.
struct RoundLimits {
  int least = 6, most = 16;
  // Rounds end where the median of every whole frame is known to this part of it; see isSettled.
  double part = 0.02;
};

struct FrameRoundsRequest {
  BenchView view;
  int mapSize = 1024;          // of VTK's own shadow map
  std::vector<Drawing> cases;  // with names of their own
  std::optional<CostClock> clock;
  RoundLimits limits;
  // Is called before each frame, and may throw to end the work.
  std::function<void()> between;
};

struct CaseBytes {
  double stored = 0.0, used = 0.0;  // per texel; see TechniqueCost
};

struct FrameRoundsResult {
  std::string renderer;
  CostClock clock = CostClock::Processor;
  int rounds = 0;
  bool settled = false;  // whether the rounds ended because the medians were known
  // Milliseconds: "vsm camera", "vsm light", "noShadow camera", "vtkShadowMapPass light", and each
  // pass after the light has moved: "vsm prefilter".
  CostSamples samples;
  std::vector<std::vector<std::string>> passes;  // of each case, in their order in a frame
  std::vector<CaseBytes> bytes;                  // of each case
};

// "camera" or "light".
std::string_view nameOf(Motion motion);
// As in CostSamples: "noShadow", "vtkShadowMapPass".
std::string_view nameOf(Baseline baseline);

// A case against the baselines: without shadows where the camera moves, VTK's shadows where the
// light does. They have no goals.
std::vector<CostRatio> ratiosOfFrames(const CostSamples& samples, std::string_view name);

// A round draws each case and each baseline once for each motion, so that what disturbs the machine
// for a while disturbs all of them. Every second round begins in new contexts, with a round that is
// not measured, since it compiles shaders.
FrameRoundsResult measureFrames(Display& display, const FrameRoundsRequest& request);

}  // namespace umbra
