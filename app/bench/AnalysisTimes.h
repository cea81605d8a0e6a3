// The times of what the program computes without a GPU.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "analysis/cost/CostRatios.h"
#include "app/display/Display.h"
#include "datasets/session/Session.h"

namespace umbra {

// These name the measurements. A comparison's seconds are those on the clock, since its point is
// that every core works; beside them stands its processor time, which other programs hardly
// disturb. A probe counts milliseconds of processor time.
inline constexpr std::string_view compare2048 = "compare-2048 seconds";
inline constexpr std::string_view compare2048Work = "compare-2048 processor";
inline constexpr std::string_view compare4096Work = "compare-4096 processor";
inline constexpr std::string_view probe65 = "probe-65 milliseconds";

// Adds to `samples` what the goals ask for, three of each comparison and more of a probe, over
// depth maps of the session's scene. Nothing is done where no goal asks. `between` is called now
// and then and may throw to end the work.
void measureAnalysis(Display& display, const Session& session, const TechniqueCatalogue& catalogue,
                     std::shared_ptr<const Scene> scene, std::span<const CostGoal> goals,
                     CostSamples& samples, const std::function<void()>& between);

}  // namespace umbra
