// The error of a whole frame, taken apart on every core.
#pragma once

#include <functional>
#include <memory>

#include "analysis/errors/ErrorDecomposition.h"
#include "analysis/frame/FrameReads.h"

namespace umbra {

// Decomposes every `stride`-th pixel of every `stride`-th row. `reference` is ShadowRenderer's;
// `technique` is the frame's, adapted to the first cascade's map. `progress` is called now and then
// with the part that is done, 0 … 1; an exception that it throws stops the work.
ErrorDecomposition decomposeFrame(const FrameSnapshot& frame, const Image<float>& reference,
                                  const std::shared_ptr<const Technique>& technique,
                                  const DecompositionSettings& how, int stride,
                                  const std::function<void(double)>& progress);

// Exact percentage-closer filtering of the pixels that decomposeFrame takes, without the GPU. It
// equals ShadowRenderer's reference but for the last bits. Other pixels are 1.
Image<float> referenceOf(const FrameSnapshot& frame, int stride,
                         const std::function<void(double)>& progress);

// The error of the map itself, whatever the technique: exact percentage-closer filtering of the map
// less the ray-traced reference `rays`. A pixel's parts and this add up to its error against rays.
// One channel, in the pixels that were taken; 0 elsewhere.
Image<double> mapErrorsOf(const ErrorDecomposition& taken, const Image<float>& reference,
                          const Image<float>& rays);
// The mean of `values` over the pixels that were taken; 0 without any.
double meanOf(const Image<double>& values, const ErrorDecomposition& taken);

// The stride at which both functions together take no longer than the technique's reads of
// `mostTaps` taps. `check` is called now and then; an exception that it throws stops the work.
int decompositionStride(
    const FrameSnapshot& frame, const Technique& technique, const DecompositionSettings& how,
    double mostTaps, const std::function<void()>& check = [] {});

}  // namespace umbra
