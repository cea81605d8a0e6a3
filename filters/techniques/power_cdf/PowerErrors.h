// What goes wrong in a fitted power function: common to power-cdf and layered-power-cdf.
#pragma once

#include <functional>

#include "filters/core/prefilter/ErrorShares.h"

namespace umbra {

// Charges rounding, then a collapsed penumbra, then the early-out or the misfit. Mean, minimum and
// maximum are as they were read, of depths under `warp`, which never falls.
void chargePower(ErrorShares& shares, double mean, double min, double max, const Region& region,
                 double receiver, const std::function<double(double)>& warp);

}  // namespace umbra
