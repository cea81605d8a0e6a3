// What storing a technique's channels costs: every storage format against double.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "analysis/plots/Plot.h"
#include "analysis/probe/Probe.h"

namespace umbra {

struct FormatPrecision {
  StorageFormat format = StorageFormat::Float;
  // Why the format cannot store the technique's channels; the other members are then empty.
  std::string refusal;
  // One sentence for each parameter that the format limits. Errors are measured against the same
  // limits, so that they are rounding alone.
  std::vector<std::string> limits;
  std::vector<double> channels;  // as read, stored in the format
  std::vector<double> errors;    // |stored − double| of each channel
  double visibility = 0.0;
  double visibilityError = 0.0;  // |stored − double|
};

struct TechniquePrecision {
  std::shared_ptr<const Technique> technique;
  std::vector<FormatPrecision> formats;  // unorm8, unorm16, half, float
};

// Measures at the request's place; the request's own format is not used.
TechniquePrecision precisionOf(const ProbeRequest& request,
                               const std::shared_ptr<const Technique>& technique);

// Plots the errors of every channel, 1 … n, and of the visibility, n + 1, as log10. An error of 0
// has no mark.
Plot precisionPlot(const TechniquePrecision& precision);

}  // namespace umbra
