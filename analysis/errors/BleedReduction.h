// The smallest light-bleeding reduction that removes all light bleeding, and what it costs.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/probe/Probe.h"
#include "filters/core/maps/Image.h"
#include "filters/core/maps/SurfaceImage.h"

namespace umbra {

// Techniques that can cut the tail of their bound off have a parameter of this name, a: visibility
// p becomes (p − a)/(1 − a), at least 0 (Lauritzen 2007, Summed-Area Variance Shadow Maps,
// GPU Gems 3, ch. 8; the idea in Lauritzen 2008, §3.4).
inline constexpr std::string_view bleedReductionName = "bleed-reduction";

struct BleedReduction {
  double amount = 0.0;  // a, within the parameter's range; 0 where nothing bleeds
  // False where light is left even with the largest amount: a bound of 1 is never reduced.
  bool removesAll = true;
  // How far below the reference the reduced visibility comes, at most and on average over all
  // receivers: a penumbra pays for what is taken from the umbra.
  double darkening = 0.0, meanDarkening = 0.0;
};

// The smallest a ≥ 0 with (p − a)/(1 − a) ≤ r, which is (p − r)/(1 − r) for p > r and else 0. Bound
// p and reference r in [0,1]; the result is 1 for p = 1 > r.
double smallestReduction(double bound, double reference);

// The amount that the technique is set to; 0 where it has no such parameter.
double bleedReduction(const Technique& technique);
// A copy of the technique with that amount; null where it has no such parameter.
std::unique_ptr<Technique> withBleedReduction(const Technique& technique, double amount);
// The parameter's largest value; nothing where the technique has no such parameter.
std::optional<double> largestBleedReduction(const Technique& technique);

// The reduction for the probe's receiver, whatever amount the technique is set to. The darkening is
// that of receivers at the region's own depths, on which the shadow's edge may fall. Nothing where
// the technique has no such parameter.
std::optional<BleedReduction> bleedReductionOf(const Probe& probe, const TechniqueResult& result);

// One receiver: the visibility without any reduction, and the reference.
struct BoundSample {
  double bound = 0.0, reference = 0.0;
};

// In an image of references: the pixel has none.
inline constexpr float noReference = -1.0F;

// The samples of a frame that was drawn without reduction, one for every pixel that receives shadow
// and has a reference.
std::vector<BoundSample> boundSamplesOf(const SurfaceImage& surfaces,
                                        const Image<float>& reference);

// The reduction for many receivers, such as the pixels of a frame: the smallest amount, up to
// `largest`, that leaves every receiver in full shadow (reference 0) dark. A penumbra's bound
// reaches 1 before its reference does, so that no amount below 1 would be enough for receivers in a
// penumbra.
// `receivers` is how many there are, where samples that no reduction changes, lit at any, are left
// out; 0 says that none is.
BleedReduction bleedReductionOver(std::span<const BoundSample> samples, double largest,
                                  std::size_t receivers = 0);

// The reduction for a frame of the technique, whatever amount it is set to. `samplesOf` measures
// the frame without any reduction, with the technique that it is given. Nothing where the technique
// has no such parameter.
std::optional<BleedReduction> bleedReductionOfFrame(
    const Technique& technique,
    const std::function<std::vector<BoundSample>(const Technique& bound)>& samplesOf);

// The reduction for receivers at depth `receiver` at every texel of a map, by point reads of the
// prefiltered map. Nothing where the technique has no such parameter.
std::optional<BleedReduction> bleedReductionOnMap(const DepthMap& map, const Technique& technique,
                                                  const Kernel& kernel, StorageFormat format,
                                                  double receiver);

}  // namespace umbra
