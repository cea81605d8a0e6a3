#include "app/frames/SceneCompare.h"

namespace umbra {
MetricsRow compareFrame(HeadlessFrame& frame, const Technique& technique,
                        const RayTracedReference* rays) {
  const Image<float> reference = rays ? rays->visibility : frame.reference();
  std::vector<BoundSample> samples = boundSamplesOf(frame.surfaces(), reference);
  MetricsSum sum;
  for (const BoundSample& sample : samples) sum.add(sample.bound, sample.reference);
  MetricsRow row{std::string(technique.info().id), sum.result(), {}};
  const std::optional<double> largest = largestBleedReduction(technique);
  if (!largest) return row;
  if (bleedReduction(technique) > 0.0) {
    frame.render(*withBleedReduction(technique, 0.0), ViewMode::Shaded);
    samples = boundSamplesOf(frame.surfaces(), reference);
  }
  row.reduction = bleedReductionOver(samples, *largest);
  return row;
}

}  // namespace umbra
