#include "analysis/errors/CompareMap.h"

#include <algorithm>
#include <utility>

#include "filters/core/prefilter/Prefilter.h"

namespace umbra {
namespace {

// The settings that are the same for all techniques of a comparison.
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
  Region place;  // a region without texels: the technique reads none
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

// Reads the regions of a map, one after another. It gathers all taps of a region only where they
// are needed.
class RegionReader {
 public:
  explicit RegionReader(const Comparison& on) : on_(on), weights_(on.kernel.weights()) {
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
    tapped_ = false;
    const auto depths = extremes_.pixel(x, y);
    for (Region* flat : {&nearest_, &farthest_}) {
      flat->x = flat->texels[0].x = x;
      flat->y = flat->texels[0].y = y;
      flat->nearestDepth = on_.map(x, y);
    }
    nearest_.texels[0].depth = depths[0];
    farthest_.texels[0].depth = depths[1];
  }

  // Evaluates `visibility` of the region. It never falls when a depth grows. Where it is the same
  // for a region that has only the smallest depth and one that has only the largest, it therefore
  // has this value.
  template <class Visibility>
  double visibility(const Visibility& visibility) {
    const double least = visibility(nearest_);
    if (least == visibility(farthest_)) return least;
    if (!tapped_) gather();
    return visibility(taps_);
  }

  // The reference of the region; `image` is its value in the reference image.
  double reference(double image) const {
    if (tapped_) return referenceVisibility(taps_, on_.receiver);
    const double least = referenceVisibility(nearest_, on_.receiver);
    return least == referenceVisibility(farthest_, on_.receiver) ? least : image;
  }

 private:
  // Does the same as regionAtTexel, but reuses the memory and the weights.
  void gather() {
    const DepthMap& map = on_.map;
    const int x = nearest_.x, y = nearest_.y, first = -on_.kernel.effectiveRadius();
    taps_ = {x, y, on_.kernel, std::move(taps_.texels), map(x, y), 1, -first, -first};
    taps_.texels.clear();
    for (std::size_t j = 0; j < weights_.size(); ++j) {
      const int row = std::clamp(y + first + int(j), 0, map.height() - 1);
      for (std::size_t i = 0; i < weights_.size(); ++i) {
        if (weights_[i] * weights_[j] == 0.0) continue;
        const int column = std::clamp(x + first + int(i), 0, map.width() - 1);
        taps_.texels.push_back({column, row, map(column, row), weights_[i] * weights_[j]});
      }
    }
    tapped_ = true;
  }

  const Comparison& on_;
  Image<double> extremes_;  // two channels: least and greatest depth of every texel's region
  Region nearest_, farthest_;
  std::vector<double> weights_;  // along either axis
  Region taps_;                  // the present texel's, where they were gathered
  bool tapped_ = false;
};

// Where taps were gathered, their own sum is the reference: a sum in another order, as in the
// reference image, would differ by rounding from the sum that the techniques use.
std::vector<Metrics> compareOverRegions(const Comparison& on,
                                        const std::vector<const Technique*>& techniques,
                                        const Image<double>& reference) {
  std::vector<MetricsSum> sums(techniques.size());
  std::vector<double> visibilities(techniques.size());
  std::vector<Image<double>> channels;
  for (const Technique* technique : techniques)
    channels.push_back(prefilteredMap(on.map, *technique, on.kernel, on.format));
  RegionReader reader(on);
  for (int y = 0; y < on.map.height(); ++y) {
    on.eachRow();
    for (int x = 0; x < on.map.width(); ++x) {
      reader.moveTo(x, y);
      for (std::size_t i = 0; i < techniques.size(); ++i)
        visibilities[i] = reader.visibility([&](const Region& region) {
          return techniques[i]->visibility({channels[i].pixel(x, y), region}, on.receiver);
        });
      const double truth = reader.reference(reference(x, y));
      for (std::size_t i = 0; i < techniques.size(); ++i) sums[i].add(visibilities[i], truth);
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
  const Image<double> reference = referenceMap(map, kernel, receiver);
  std::vector<Metrics> results(techniques.size());
  std::vector<const Technique*> readingTexels;
  std::vector<std::size_t> theirPlaces;
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    if (techniques[i]->info().prefilterable) {
      results[i] = comparePrefiltered(on, *techniques[i], reference);
    } else {
      readingTexels.push_back(techniques[i].get());
      theirPlaces.push_back(i);
    }
  }
  if (readingTexels.empty()) return results;
  const auto compared = compareOverRegions(on, readingTexels, reference);
  for (std::size_t i = 0; i < compared.size(); ++i) results[theirPlaces[i]] = compared[i];
  return results;
}

}  // namespace umbra
