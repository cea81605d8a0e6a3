#include "analysis/errors/CompareMap.h"

#include <algorithm>
#include <utility>

#include "analysis/frame/EveryCore.h"
#include "filters/core/prefilter/Prefilter.h"

namespace umbra {
namespace {

// The settings that are the same for all techniques of a comparison.
struct Comparison {
  const DepthMap& map;
  const Kernel& kernel;
  StorageFormat format;
  double receiver;
};

// Strips begin where a window of the kernel does, so that each is computed as in the whole map.
// Rows beyond a strip are computed for both of the strips that reach them: strips are several times
// as high as a window.
class Strips {
 public:
  Strips(const DepthMap& map, const Kernel& kernel) : height_(map.height()) {
    const int window = 2 * kernel.effectiveRadius() + 1, least = std::max(64, 4 * window);
    rows_ = (least + window - 1) / window * window;
  }
  int count() const { return (height_ + rows_ - 1) / rows_; }
  Rows operator[](int strip) const {
    const int first = strip * rows_;
    return {first, std::min(rows_, height_ - first)};
  }

 private:
  int height_, rows_ = 0;
};

Image<double> referenceRows(const DepthMap& map, const Kernel& kernel, double receiver,
                            const Rows& rows) {
  const Rows known = reachedRows(kernel, rows, map.height());
  Image<double> lit(map.width(), known.count);
  for (int y = 0; y < known.count; ++y)
    for (int x = 0; x < map.width(); ++x)
      lit(x, y) = map(x, known.first + y) >= receiver ? 1.0 : 0.0;
  const Channel mean{"lit"};
  Image<double> reference =
      kernel.effectiveRadius() == 0 ? lit : reducedRows(lit, {&mean, 1}, kernel, known, rows);
  // A Gaussian's weights may add up to a little more than 1.
  for (double& value : reference.values()) value = std::min(value, 1.0);
  return reference;
}

// What one strip adds to a technique's figures.
struct StripFigures {
  MetricsSum metrics;
  std::vector<BoundSample> samples;  // that a reduction may change
};

// Without any reduction a lit receiver stays lit: only darker ones tell how much one takes.
bool mayDarken(const BoundSample& sample) {
  return sample.bound < 1.0 || sample.reference == 0.0;
}

// `bound` is the technique without its reduction; null where it has none to set.
StripFigures figuresOfStrip(const Comparison& on, const Technique& technique,
                            const Technique* bound, const Image<double>& reference,
                            const Rows& rows) {
  const Image<double> channels = prefilteredRows(on.map, technique, on.kernel, on.format, rows);
  const bool isUnreduced = bleedReduction(technique) == 0.0;
  StripFigures figures;
  Region place;  // a region without texels: the technique reads none
  place.kernel = on.kernel;
  for (int y = rows.first; y < rows.first + rows.count; ++y)
    for (int x = 0; x < on.map.width(); ++x) {
      place.x = x;
      place.y = y;
      place.nearestDepth = on.map(x, y);
      const Fetch fetch{channels.pixel(x, y - rows.first), place};
      const double visibility = technique.visibility(fetch, on.receiver);
      figures.metrics.add(visibility, reference(x, y));
      if (!bound) continue;
      const BoundSample sample{isUnreduced ? visibility : bound->visibility(fetch, on.receiver),
                               reference(x, y)};
      if (mayDarken(sample)) figures.samples.push_back(sample);
    }
  return figures;
}

MapFigures figuresOf(const Comparison& on, const Technique& technique, bool withReduction,
                     const Image<double>& reference, const std::function<void()>& between) {
  const std::optional<double> largest =
      withReduction ? largestBleedReduction(technique) : std::nullopt;
  const std::unique_ptr<Technique> bound = largest ? withBleedReduction(technique, 0.0) : nullptr;
  const Strips strips(on.map, on.kernel);
  std::vector<StripFigures> parts(std::size_t(strips.count()));
  onEveryCore(
      strips.count(),
      [&](int strip) {
        parts[std::size_t(strip)] =
            figuresOfStrip(on, technique, bound.get(), reference, strips[strip]);
      },
      [&](int) { between(); });
  MetricsSum metrics;
  std::vector<BoundSample> samples;
  for (StripFigures& part : parts) {
    metrics.add(part.metrics);
    samples.insert(samples.end(), part.samples.begin(), part.samples.end());
    part.samples = {};
  }
  MapFigures figures{metrics.result(), {}};
  if (largest) figures.reduction = bleedReductionOver(samples, *largest, on.map.values().size());
  return figures;
}

// Reads the regions of some rows of a map, one after another. It gathers all taps of a region only
// where they are needed.
class RegionReader {
 public:
  RegionReader(const Comparison& on, const Rows& rows)
      : on_(on), firstRow_(rows.first), weights_(on.kernel.weights()) {
    const Channel extremes[] = {{"min", Reduction::Min}, {"max", Reduction::Max}};
    const Rows known = reachedRows(on.kernel, rows, on.map.height());
    Image<double> depths(on.map.width(), known.count, 2);
    for (int y = 0; y < known.count; ++y)
      for (int x = 0; x < on.map.width(); ++x)
        depths(x, y, 0) = depths(x, y, 1) = on.map(x, known.first + y);
    extremes_ = reducedRows(depths, extremes, on.kernel, known, rows);
    for (Region* flat : {&nearest_, &farthest_}) {
      flat->kernel = on.kernel;
      flat->texels = {{0, 0, 0.0, 1.0}};
    }
  }

  void moveTo(int x, int y) {
    tapped_ = false;
    const auto depths = extremes_.pixel(x, y - firstRow_);
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
  const int firstRow_;
  Image<double> extremes_;  // two channels: least and greatest depth of every texel's region
  Region nearest_, farthest_;
  std::vector<double> weights_;  // along either axis
  Region taps_;                  // the present texel's, where they were gathered
  bool tapped_ = false;
};

// Where taps were gathered, their own sum is the reference: a sum in another order, as in the
// reference image, would differ by rounding from the sum that the techniques use.
std::vector<MetricsSum> compareStripOverRegions(const Comparison& on,
                                                const std::vector<const Technique*>& techniques,
                                                const Image<double>& reference, const Rows& rows) {
  std::vector<MetricsSum> sums(techniques.size());
  std::vector<double> visibilities(techniques.size());
  std::vector<Image<double>> channels;
  for (const Technique* technique : techniques)
    channels.push_back(prefilteredRows(on.map, *technique, on.kernel, on.format, rows));
  RegionReader reader(on, rows);
  for (int y = rows.first; y < rows.first + rows.count; ++y)
    for (int x = 0; x < on.map.width(); ++x) {
      reader.moveTo(x, y);
      for (std::size_t i = 0; i < techniques.size(); ++i)
        visibilities[i] = reader.visibility([&](const Region& region) {
          return techniques[i]->visibility({channels[i].pixel(x, y - rows.first), region},
                                           on.receiver);
        });
      const double truth = reader.reference(reference(x, y));
      for (std::size_t i = 0; i < techniques.size(); ++i) sums[i].add(visibilities[i], truth);
    }
  return sums;
}

std::vector<Metrics> compareOverRegions(const Comparison& on,
                                        const std::vector<const Technique*>& techniques,
                                        const Image<double>& reference,
                                        const std::function<void()>& between) {
  const Strips strips(on.map, on.kernel);
  std::vector<std::vector<MetricsSum>> parts(std::size_t(strips.count()));
  onEveryCore(
      strips.count(),
      [&](int strip) {
        parts[std::size_t(strip)] =
            compareStripOverRegions(on, techniques, reference, strips[strip]);
      },
      [&](int) { between(); });
  std::vector<Metrics> results;
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    MetricsSum sum;
    for (const std::vector<MetricsSum>& part : parts) sum.add(part[i]);
    results.push_back(sum.result());
  }
  return results;
}

std::vector<MapFigures> figuresOnMap(const Comparison& on,
                                     std::span<const std::shared_ptr<const Technique>> techniques,
                                     bool withReduction, const std::function<void()>& between) {
  const Image<double> reference = referenceMap(on.map, on.kernel, on.receiver);
  std::vector<MapFigures> results(techniques.size());
  std::vector<const Technique*> readingTexels;
  std::vector<std::size_t> theirPlaces;
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    if (techniques[i]->info().prefilterable) {
      results[i] = figuresOf(on, *techniques[i], withReduction, reference, between);
    } else {
      readingTexels.push_back(techniques[i].get());
      theirPlaces.push_back(i);
    }
  }
  if (readingTexels.empty()) return results;
  const auto compared = compareOverRegions(on, readingTexels, reference, between);
  for (std::size_t i = 0; i < compared.size(); ++i) results[theirPlaces[i]].metrics = compared[i];
  return results;
}

}  // namespace

Image<double> referenceMap(const DepthMap& map, const Kernel& kernel, double receiver) {
  Image<double> reference(map.width(), map.height());
  const Strips strips(map, kernel);
  onEveryCore(
      strips.count(),
      [&](int strip) {
        const Image<double> part = referenceRows(map, kernel, receiver, strips[strip]);
        std::copy(part.values().begin(), part.values().end(),
                  reference.pixel(0, strips[strip].first).data());
      },
      [](int) {});
  return reference;
}

std::vector<MapFigures> figuresOnMap(const DepthMap& map,
                                     std::span<const std::shared_ptr<const Technique>> techniques,
                                     const Kernel& kernel, StorageFormat format, double receiver,
                                     const std::function<void()>& between) {
  return figuresOnMap(Comparison{map, kernel, format, receiver}, techniques, true, between);
}

std::vector<Metrics> compareOnMap(const DepthMap& map,
                                  std::span<const std::shared_ptr<const Technique>> techniques,
                                  const Kernel& kernel, StorageFormat format, double receiver,
                                  const std::function<void()>& between) {
  std::vector<Metrics> metrics;
  for (const MapFigures& figures :
       figuresOnMap(Comparison{map, kernel, format, receiver}, techniques, false, between))
    metrics.push_back(figures.metrics);
  return metrics;
}

}  // namespace umbra
