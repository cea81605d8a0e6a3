#include "analysis/CompareMap.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "filters/core/Prefilter.h"

namespace umbra {
namespace {

// What all techniques are measured on.
struct Comparison {
  const DepthMap& map;
  const Kernel& kernel;
  StorageFormat format;
  double receiver;
  const std::function<void()>& eachRow;
};

Metrics comparePrefiltered(const Comparison& on, const Technique& technique,
                           const Image<double>& reference) {
  const Image<double> channels = prefilteredMap(on.map, technique, on.kernel, on.format);
  MetricsSum sum;
  Region place;  // without texels: the technique reads none
  place.kernel = on.kernel;
  for (int y = 0; y < on.map.height(); ++y) {
    on.eachRow();
    for (int x = 0; x < on.map.width(); ++x) {
      place.x = x;
      place.y = y;
      place.nearestDepth = on.map(x, y);
      sum.add(technique.visibility({channels.pixel(x, y), place}, on.receiver), reference(x, y));
    }
  }
  return sum.result();
}

// The regions of a map, one after another: with all their taps only where somebody needs them.
class RegionReader {
 public:
  explicit RegionReader(const Comparison& on) : on_(on) {
    const Channel extremes[] = {{"min", Reduction::Min}, {"max", Reduction::Max}};
    Image<double> depths(on.map.width(), on.map.height(), 2);
    for (std::size_t i = 0; i < on.map.values().size(); ++i)
      depths.values()[2 * i] = depths.values()[2 * i + 1] = on.map.values()[i];
    extremes_ = reduceMap(depths, extremes, on.kernel);
    for (Region* flat : {&nearest_, &farthest_}) {
      flat->kernel = on.kernel;
      flat->texels = {{0, 0, 0.0, 1.0}};
    }
  }

  void moveTo(int x, int y) {
    taps_.reset();
    const auto depths = extremes_.pixel(x, y);
    for (Region* flat : {&nearest_, &farthest_}) {
      flat->x = flat->texels[0].x = x;
      flat->y = flat->texels[0].y = y;
      flat->nearestDepth = on_.map(x, y);
    }
    nearest_.texels[0].depth = depths[0];
    farthest_.texels[0].depth = depths[1];
  }

  // `visibility` of a region. It never falls when a depth grows, so that it is known from two
  // regions of one depth, the smallest and the largest, where it is the same for both.
  template <class Visibility>
  double visibility(const Visibility& visibility) {
    const double least = visibility(nearest_);
    if (least == visibility(farthest_)) return least;
    if (!taps_) taps_ = regionAtTexel(on_.map, on_.kernel, nearest_.x, nearest_.y);
    return visibility(*taps_);
  }

 private:
  const Comparison& on_;
  Image<double> extremes_;  // two channels: least and greatest depth of every texel's region
  Region nearest_, farthest_;
  std::optional<Region> taps_;  // of the texel moved to
};

// The regions' own sum is the reference: the sum in another order would differ by rounding from
// what the techniques add up themselves.
std::vector<Metrics> compareOverRegions(const Comparison& on,
                                        const std::vector<const Technique*>& techniques) {
  std::vector<MetricsSum> sums(techniques.size());
  std::vector<Image<double>> channels;
  for (const Technique* technique : techniques)
    channels.push_back(prefilteredMap(on.map, *technique, on.kernel, on.format));
  RegionReader reader(on);
  for (int y = 0; y < on.map.height(); ++y) {
    on.eachRow();
    for (int x = 0; x < on.map.width(); ++x) {
      reader.moveTo(x, y);
      const double reference = reader.visibility(
          [&](const Region& region) { return referenceVisibility(region, on.receiver); });
      for (std::size_t i = 0; i < techniques.size(); ++i)
        sums[i].add(reader.visibility([&](const Region& region) {
          return techniques[i]->visibility({channels[i].pixel(x, y), region}, on.receiver);
        }),
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
                                  const Kernel& kernel, StorageFormat format, double receiver,
                                  const std::function<void()>& eachRow) {
  const Comparison on{map, kernel, format, receiver, eachRow};
  std::optional<Image<double>> reference;  // of the prefilterable ones, made for the first
  std::vector<Metrics> results(techniques.size());
  std::vector<const Technique*> readingTexels;
  std::vector<std::size_t> theirPlaces;
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    if (techniques[i]->info().prefilterable) {
      if (!reference) reference = referenceMap(map, kernel, receiver);
      results[i] = comparePrefiltered(on, *techniques[i], *reference);
    } else {
      readingTexels.push_back(techniques[i].get());
      theirPlaces.push_back(i);
    }
  }
  if (readingTexels.empty()) return results;
  const auto compared = compareOverRegions(on, readingTexels);
  for (std::size_t i = 0; i < compared.size(); ++i) results[theirPlaces[i]] = compared[i];
  return results;
}

}  // namespace umbra
