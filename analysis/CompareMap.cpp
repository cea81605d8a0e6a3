#include "analysis/CompareMap.h"

#include <algorithm>
#include <utility>

#include "filters/core/Prefilter.h"

namespace umbra {
namespace {

Metrics comparePrefiltered(const DepthMap& map, const Technique& technique, const Kernel& kernel,
                           StorageFormat format, double receiver, const Image<double>& reference) {
  const Image<double> channels = prefilteredMap(map, technique, kernel, format);
  MetricsSum sum;
  Region place;  // without texels: the technique reads none
  place.kernel = kernel;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      place.x = x;
      place.y = y;
      place.nearestDepth = map(x, y);
      sum.add(technique.visibility({channels.pixel(x, y), place}, receiver), reference(x, y));
    }
  }
  return sum.result();
}

// A region is made once for all the techniques that read its texels, and its own sum is the
// reference: the sum in another order would differ by rounding from what they add up themselves.
std::vector<Metrics> compareOverRegions(const DepthMap& map,
                                        const std::vector<const Technique*>& techniques,
                                        const Kernel& kernel, StorageFormat format,
                                        double receiver) {
  std::vector<MetricsSum> sums(techniques.size());
  std::vector<Image<double>> channels;
  for (const Technique* technique : techniques)
    channels.push_back(prefilteredMap(map, *technique, kernel, format));
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const Region region = regionAtTexel(map, kernel, x, y);
      const double reference = referenceVisibility(region, receiver);
      for (std::size_t i = 0; i < techniques.size(); ++i)
        sums[i].add(techniques[i]->visibility({channels[i].pixel(x, y), region}, receiver),
                    reference);
    }
  }
  std::vector<Metrics> results;
  for (const MetricsSum& sum : sums) results.push_back(sum.result());
  return results;
}

}  // namespace

Image<double> referenceMap(const DepthMap& map, const Kernel& kernel, double receiver) {
  Image<double> lit(map.width(), map.height());
  std::transform(map.values().begin(), map.values().end(), lit.values().begin(),
                 [receiver](double depth) { return depth >= receiver ? 1.0 : 0.0; });
  const Channel mean{"lit"};
  Image<double> reference = reduceMap(lit, {&mean, 1}, kernel);
  // A Gaussian's weights may add up to a little more than 1.
  for (double& value : reference.values()) value = std::min(value, 1.0);
  return reference;
}

std::vector<Metrics> compareOnMap(const DepthMap& map,
                                  std::span<const std::shared_ptr<const Technique>> techniques,
                                  const Kernel& kernel, StorageFormat format, double receiver) {
  const Image<double> reference = referenceMap(map, kernel, receiver);
  std::vector<Metrics> results(techniques.size());
  std::vector<const Technique*> readingTexels;
  std::vector<std::size_t> theirPlaces;
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    if (techniques[i]->info().prefilterable) {
      results[i] = comparePrefiltered(map, *techniques[i], kernel, format, receiver, reference);
    } else {
      readingTexels.push_back(techniques[i].get());
      theirPlaces.push_back(i);
    }
  }
  if (readingTexels.empty()) return results;
  const auto compared = compareOverRegions(map, readingTexels, kernel, format, receiver);
  for (std::size_t i = 0; i < compared.size(); ++i) results[theirPlaces[i]] = compared[i];
  return results;
}

}  // namespace umbra
