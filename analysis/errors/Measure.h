// A quantity by name, from what was probed or compared.
#pragma once

#include <optional>
#include <string_view>

#include "analysis/errors/Metrics.h"
#include "analysis/probe/Probe.h"
#include "filters/core/support/Quantity.h"

namespace umbra {

// The result of the technique with this id; null where the probe has none.
const TechniqueResult* techniqueResult(const Probe& probe, std::string_view technique);

// Of a probe. None for a technique that the probe has no result of, and for a quantity of a frame.
std::optional<double> measured(const Probe& probe, Quantity quantity, std::string_view technique);

// Of a frame; `quantity` must be one of those (QuantityInfo::ofFrame).
double measured(const Metrics& metrics, Quantity quantity);

// Why the technique's visibility at the probe is what it is, in one sentence with the region's
// numbers; "" where the technique explains nothing.
std::string causeOf(const Probe& probe, std::string_view technique);

}  // namespace umbra
