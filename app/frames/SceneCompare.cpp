#include "app/frames/SceneCompare.h"

namespace umbra {
MetricsRow compareFrame(HeadlessFrame& frame, const Technique& technique,
                        const RayTracedReference* rays) {
  const Image<float> reference = rays ? rays->visibility : frame.reference();
  const std::vector<BoundSample> samples = boundSamplesOf(frame.surfaces(), reference);
  MetricsSum sum;
  for (const BoundSample& sample : samples) sum.add(sample.bound, sample.reference);
  MetricsRow row{std::string(technique.info().id), sum.result(), {}};
  row.reduction = bleedReductionOfFrame(technique, [&](const Technique& bound) {
    if (bleedReduction(technique) == 0.0) return samples;
    frame.render(bound, ViewMode::Shaded);
    return boundSamplesOf(frame.surfaces(), reference);
  });
  return row;
}

}  // namespace umbra
