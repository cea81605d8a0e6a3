// Rows of the field tables that techniques with an upper bound share.
#pragma once

#include <string_view>

#include "filters/core/support/Parameters.h"

namespace umbra {

template <class P>
constexpr Field<P, double> minVarianceField(std::string_view doc) {
  return {&P::minVariance, "min-variance", "σ²min", "depth²", 0.0, 1e-2, doc, Scale::Logarithmic};
}

template <class P>
constexpr Field<P, double> bleedReductionField() {
  return {&P::bleedReduction,
          "bleed-reduction",
          "a",
          "",
          0.0,
          0.99,
          "Visibilities up to a become 0, the rest is stretched; darkens penumbrae."};
}

}  // namespace umbra
