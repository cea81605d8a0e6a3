#include "app/frames/SceneCompare.h"

namespace umbra {
namespace {

std::vector<BoundSample> samplesOf(HeadlessFrame& frame, const Image<float>& reference) {
  Image<float> surfaces = frame.surfaces();
  for (int y = 0; y < surfaces.height(); ++y)
    for (int x = 0; x < surfaces.width(); ++x)
      if (reference(x, y) == RayTracedReference::absent) surfaces(x, y, 0) = -1.0f;
  return boundSamplesOf(surfaces, reference);
}

}  // namespace

MetricsRow compareFrame(HeadlessFrame& frame, const Technique& technique,
                        const RayTracedReference* rays) {
  const Image<float> reference = rays ? rays->visibility : frame.reference();
  std::vector<BoundSample> samples = samplesOf(frame, reference);
  MetricsSum sum;
  for (const BoundSample& sample : samples) sum.add(sample.bound, sample.reference);
  MetricsRow row{std::string(technique.info().id), sum.result(), {}};
  const std::optional<double> largest = largestBleedReduction(technique);
  if (!largest) return row;
  if (bleedReduction(technique) > 0.0) {
    frame.render(*withBleedReduction(technique, 0.0), ViewMode::Shaded);
    samples = samplesOf(frame, reference);
  }
  row.reduction = bleedReductionOver(samples, *largest);
  return row;
}

}  // namespace umbra
