// The Hamburger four-moment bound (Peters & Klein 2015, algorithm 3).
#pragma once

#include <array>

#include "filters/core/technique/Trace.h"

namespace umbra {

// Power moments of depth: E[z], E[z²], E[z³], E[z⁴].
using Moments4 = std::array<double, 4>;

// The moments of depth −1 … 1, x = 2z − 1, mapped so that each fills [0, 1] and fits 16 bits a
// channel (Peters & Klein 2015, the optimised quantisation). `fromQuantised` is the inverse.
Moments4 toQuantised(double z);
Moments4 fromQuantised(const Moments4& channels);

// The largest share of depths that may lie at or behind `receiver` given the moments, after these
// were moved by `bias` towards (½, ½, ½, ½): that makes rounded moments those of a distribution
// again. It is never below the true share less bias/2. The result is in [0,1]; bias > 0.
double hamburgerVisibility(const Moments4& moments, double receiver, double bias);
// The same, recording its steps.
double hamburgerVisibility(const Moments4& moments, double receiver, double bias,
                           const TraceRecorder& record);

}  // namespace umbra
