// The error of a whole frame, taken apart on every core.
#pragma once

#include <functional>
#include <memory>

#include "analysis/errors/ErrorDecomposition.h"
#include "analysis/frame/DrawnFrame.h"

namespace umbra {

// `reference` as ShadowRenderer gives it; `technique` as the frame was drawn with it, adapted to
// the first cascade's map. Of every `stride`-th pixel of every `stride`-th row. `progress` is
// called now and then with the part that is done, 0 … 1; what it throws stops the work.
ErrorDecomposition decomposeFrame(const DrawnFrame& frame, const Image<float>& reference,
                                  const std::shared_ptr<const Technique>& technique,
                                  const DecompositionSettings& how, int stride,
                                  const std::function<void(double)>& progress);

// Exact percentage-closer filtering of the pixels that this takes, like ShadowRenderer's reference
// but for the last bits, without asking the GPU; 1 elsewhere.
Image<float> referenceOf(const DrawnFrame& frame, int stride,
                         const std::function<void(double)>& progress);

// The stride at which both together take as long as the technique's reads of some `mostTaps` taps,
// or less.
// What `check`, called now and then, throws stops it.
int decompositionStride(
    const DrawnFrame& frame, const Technique& technique, const DecompositionSettings& how,
    double mostTaps, const std::function<void()>& check = [] {});

}  // namespace umbra
