// What can be claimed of a cell, as names of a row of a sweep.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "datasets/plans/SweepPlan.h"

namespace umbra {

struct FigureMeasure {
  std::string_view name;                      // "bleeding", "probe.visibility", "cost.shadeMs"
  SweepMeasure asks = SweepMeasure::Compare;  // what a sweep must measure for it
  std::string_view definition;                // one sentence, with its unit
};

std::span<const FigureMeasure> figureMeasures();
// Throws BadInput for an unknown name, with the nearest one.
const FigureMeasure& figureMeasureNamed(const std::string& name, const std::string& where);

// The measure in a row as SweepRunner makes it; nothing where the row lacks it.
std::optional<double> measureIn(const nlohmann::ordered_json& row, std::string_view measure);

}  // namespace umbra
