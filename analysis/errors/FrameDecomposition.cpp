#include "analysis/errors/FrameDecomposition.h"

#include "analysis/errors/BleedReduction.h"
#include "analysis/frame/EveryCore.h"

namespace umbra {

ErrorDecomposition decomposeFrame(const FrameSnapshot& frame, const Image<float>& reference,
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

Image<float> referenceOf(const FrameSnapshot& frame, int stride,
                         const std::function<void(double)>& progress) {
  const SurfaceImage& surfaces = frame.surfaces;
  Image<float> reference(surfaces.width(), surfaces.height(), 1, 1.0f);
  const int rows = (surfaces.height() + stride - 1) / stride;
  onEveryCore(
      rows,
      [&](int row) {
        const int y = row * stride;
        for (int x = 0; x < surfaces.width(); x += stride)
          if (surfaces.receivesShadow(x, y))
            reference(x, y) = float(takeProbe(requestAt(frame, x, y)).reference);
      },
      [&](int begun) { progress(double(begun) / rows); });
  return reference;
}

Image<double> mapErrorsOf(const ErrorDecomposition& taken, const Image<float>& reference,
                          const Image<float>& rays) {
  Image<double> errors(reference.width(), reference.height());
  for (int y = 0; y < errors.height(); ++y)
    for (int x = 0; x < errors.width(); ++x)
      if (taken.receives(x, y)) errors(x, y) = double(reference(x, y)) - double(rays(x, y));
  return errors;
}

double meanOf(const Image<double>& values, const ErrorDecomposition& taken) {
  double sum = 0.0;
  std::size_t pixels = 0;
  for (int y = 0; y < values.height(); ++y)
    for (int x = 0; x < values.width(); ++x) {
      if (!taken.receives(x, y)) continue;
      sum += values(x, y);
      ++pixels;
    }
  return pixels > 0 ? sum / double(pixels) : 0.0;
}

int decompositionStride(const FrameSnapshot& frame, const Technique& technique,
                        const DecompositionSettings& how, double mostTaps,
                        const std::function<void()>& check) {
  constexpr int step = 16;  // the cost is judged by every sixteenth pixel along both axes
  constexpr double referenceTap = 0.1;  // the cost of a tap of which no channels are made
  const bool reduces = bleedReduction(technique) > 0.0;
  double cost = 0.0;
  for (int y = 0; y < frame.surfaces.height(); y += step)
    for (int x = 0; x < frame.surfaces.width(); x += step) {
      if (!frame.surfaces.receivesShadow(x, y)) continue;
      check();
      const Probe probe = takeProbe(requestAt(frame, x, y));
      const bool taken =
          worthDecomposing(frame.surfaces.visibility(x, y), probe.reference, reduces, how);
      const double reads = taken ? (reduces ? 2.0 : 1.0) : 0.0;
      cost += (referenceTap + reads) * double(probe.region.texels.size());
    }
  return strideFor(cost * step * step, mostTaps);
}

}  // namespace umbra
