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
  // Why the technique cannot be stored so; then the rest is empty.
  std::string refusal;
  // Of each parameter that the format limits, one sentence. Errors are those of the technique with
  // these limits, so that they are rounding alone.
  std::vector<std::string> limits;
  std::vector<double> channels;  // as read, stored in the format
  std::vector<double> errors;    // of these: |stored − double|
  double visibility = 0.0;
  double visibilityError = 0.0;  // |stored − double|
};

struct TechniquePrecision {
  std::shared_ptr<const Technique> technique;
  std::vector<FormatPrecision> formats;  // unorm8, unorm16, half, float
};

// At the place of the request, whatever format it names.
TechniquePrecision precisionOf(const ProbeRequest& request,
                               const std::shared_ptr<const Technique>& technique);

// The errors of every channel, 1 … n, and of the visibility, n + 1, as log10; an error of 0 has no
// mark.
Plot precisionPlot(const TechniquePrecision& precision);

}  // namespace umbra
