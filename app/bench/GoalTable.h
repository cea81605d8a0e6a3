// What the program's costs are to come to, and the cases that say whether they do.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/cost/CostRatios.h"
#include "app/frames/Drawings.h"
#include "datasets/session/Session.h"

namespace umbra {

// A technique with settings that differ from those of the whole run.
struct GoalCase {
  std::string_view name, technique;
  // Names as in `umbrascope settings` and TECHNIQUE.PARAMETER: "kernel.radius=32 vsm.…=…".
  std::string_view settings;
};

// Measurements are named as in FrameRoundsResult::samples, beside those of AnalysisTimes.
std::span<const CostGoal> allGoals();

// On what all goals are measured: the scene `car` with a small blur.
Session goalSession();

// The goals whose names contain one of the texts, or all where there are none. With `techniques`,
// only goals that compare these alone. Throws BadCommandLine where none is left.
std::vector<CostGoal> goalsNamed(std::span<const std::string> texts,
                                 std::span<const std::string> techniques);

// The cases that the goals compare, in the order of the table, each over `base`.
std::vector<Drawing> casesOf(std::span<const CostGoal> goals, const Session& base,
                             const TechniqueCatalogue& catalogue);

// Whether a goal names this measurement.
bool asksFor(std::span<const CostGoal> goals, std::string_view measurement);

}  // namespace umbra
