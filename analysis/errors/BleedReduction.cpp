#include "analysis/errors/BleedReduction.h"

#include <algorithm>

#include "analysis/errors/CompareMap.h"

namespace umbra {
namespace {

// The accuracy of a reduction. It is finer than every format but double, and covers double's
// rounding.
constexpr double rounding = 1e-12;

double reduced(double bound, double amount) {
  return std::clamp((bound - amount) / (1.0 - amount), 0.0, 1.0);
}

// Where a technique mixes several reduced bounds, as LVSM does between its layers, the closed form
// for one bound may be too small; the rest is then found by halving.
double halved(const TechniqueResult& result, const Probe& probe, double low, double high) {
  const auto bleeds = [&](double amount) {
    return visibilityOf(*withBleedReduction(*result.technique, amount), probe, result,
                        probe.receiver) > probe.reference + rounding;
  };
  if (!bleeds(low)) return low;
  while (high - low > rounding) {
    const double middle = 0.5 * (low + high);
    (bleeds(middle) ? low : high) = middle;
  }
  return high;
}

// The reference only falls where the receiver passes a depth of the region. A visibility that falls
// with the receiver's depth is therefore darkened most at one of these depths.
void addDarkening(const TechniqueResult& result, const Probe& probe, BleedReduction& found) {
  const std::unique_ptr<Technique> technique = withBleedReduction(*result.technique, found.amount);
  const EmpiricalCdf cdf = empiricalCdfOf(probe.region);
  double inFront = 0.0;
  for (std::size_t i = 0; i < cdf.depth.size(); ++i) {
    const double darkening =
        std::max(0.0, 1.0 - inFront - visibilityOf(*technique, probe, result, cdf.depth[i]));
    found.darkening = std::max(found.darkening, darkening);
    found.meanDarkening += darkening * (cdf.cumulative[i] - inFront);
    inFront = cdf.cumulative[i];
  }
}

}  // namespace

double smallestReduction(double bound, double reference) {
  return bound > reference ? (bound - reference) / (1.0 - reference) : 0.0;
}

std::optional<double> largestBleedReduction(const Technique& technique) {
  for (const ParameterView& parameter : technique.parameters())
    if (parameter.name == bleedReductionName) return parameter.high;
  return std::nullopt;
}

double bleedReduction(const Technique& technique) {
  for (const ParameterView& parameter : technique.parameters())
    if (parameter.name == bleedReductionName) return std::get<double>(parameter.get());
  return 0.0;
}

std::unique_ptr<Technique> withBleedReduction(const Technique& technique, double amount) {
  std::unique_ptr<Technique> copy = technique.clone();
  for (const Parameter& parameter : copy->parameters())
    if (parameter.name == bleedReductionName) {
      parameter.set(amount, bleedReductionName);
      return copy;
    }
  return nullptr;
}

std::optional<BleedReduction> bleedReductionOf(const Probe& probe, const TechniqueResult& result) {
  const std::optional<double> largest = largestBleedReduction(*result.technique);
  if (!largest) return std::nullopt;
  const auto visibility = [&](double amount) {
    return visibilityOf(*withBleedReduction(*result.technique, amount), probe, result,
                        probe.receiver);
  };
  BleedReduction found;
  found.amount = std::min(smallestReduction(visibility(0.0), probe.reference), *largest);
  if (visibility(*largest) > probe.reference + rounding) {
    found.amount = *largest;
    found.removesAll = false;
  } else {
    found.amount = halved(result, probe, found.amount, *largest);
  }
  addDarkening(result, probe, found);
  return found;
}

std::vector<BoundSample> boundSamplesOf(const SurfaceImage& surfaces,
                                        const Image<float>& reference) {
  std::vector<BoundSample> samples;
  for (int y = 0; y < surfaces.height(); ++y)
    for (int x = 0; x < surfaces.width(); ++x)
      if (surfaces.receivesShadow(x, y) && reference(x, y) != noReference)
        samples.push_back({surfaces.visibility(x, y), reference(x, y)});
  return samples;
}

BleedReduction bleedReductionOver(std::span<const BoundSample> samples, double largest,
                                  std::size_t receivers) {
  const double count = double(receivers > 0 ? receivers : samples.size());
  BleedReduction found;
  for (const BoundSample& sample : samples)
    if (sample.reference == 0.0) found.amount = std::max(found.amount, sample.bound);
  found.removesAll = found.amount <= largest;
  found.amount = std::min(found.amount, largest);
  for (const BoundSample& sample : samples) {
    const double darkening = std::max(0.0, sample.reference - reduced(sample.bound, found.amount));
    found.darkening = std::max(found.darkening, darkening);
    found.meanDarkening += darkening / count;
  }
  return found;
}

std::optional<BleedReduction> bleedReductionOfFrame(
    const Technique& technique,
    const std::function<std::vector<BoundSample>(const Technique& bound)>& samplesOf) {
  const std::optional<double> largest = largestBleedReduction(technique);
  if (!largest) return std::nullopt;
  return bleedReductionOver(samplesOf(*withBleedReduction(technique, 0.0)), *largest);
}

std::optional<BleedReduction> bleedReductionOnMap(const DepthMap& map, const Technique& technique,
                                                  const Kernel& kernel, StorageFormat format,
                                                  double receiver) {
  if (!largestBleedReduction(technique)) return std::nullopt;
  const std::vector<std::shared_ptr<const Technique>> one{technique.clone()};
  return figuresOnMap(map, one, kernel, format, receiver).front().reduction;
}

}  // namespace umbra
