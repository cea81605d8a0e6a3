#include "analysis/FrameDecomposition.h"

#include "analysis/BleedReduction.h"
#include "analysis/EveryCore.h"
#include "analysis/ReceiverPixels.h"

namespace umbra {

ErrorDecomposition decomposeFrame(const DrawnFrame& frame, const Image<float>& reference,
                                  const std::shared_ptr<const Technique>& technique,
                                  const DecompositionSettings& how, int stride,
                                  const std::function<void(double)>& progress) {
  const int width = frame.surfaces.width(), height = frame.surfaces.height();
  const auto techniques = decompositionTechniques(technique);
  ErrorDecomposition result = emptyDecomposition(width, height, stride);
  const auto probe = [&](int x, int y) {
    ProbeRequest request = requestAt(frame, x, y);
    request.format = StorageFormat::Double;
    request.techniques = techniques;
    return takeProbe(request);
  };
  const int rows = (height + stride - 1) / stride;
  onEveryCore(
      rows,
      [&](int row) {
        decomposeRow(frame.surfaces, reference, row * stride, techniques.size() > 1, probe, how,
                     result);
      },
      [&](int begun) { progress(double(begun) / rows); });
  return result;
}

int decompositionStride(const DrawnFrame& frame, const Image<float>& reference,
                        const Technique& technique, const DecompositionSettings& how,
                        double mostTaps) {
  const bool reduces = bleedReduction(technique) > 0.0;
  const double taps = tapsOf(frame, [&](int x, int y) {
    return receivesShadow(frame.surfaces.pixel(x, y)) &&
           worthDecomposing(frame.surfaces(x, y, 3), reference(x, y), reduces, how);
  });
  return strideFor(reduces ? 2.0 * taps : taps, mostTaps);
}

}  // namespace umbra
