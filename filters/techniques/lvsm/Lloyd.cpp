#include "filters/techniques/lvsm/Lloyd.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace umbra {
namespace {

// Samples in ascending order with running sums, so that an iteration costs a few look-ups however
// many samples there are. Sums of a range are differences of running sums; they are kept in long
// double, about mid-depth, lest the difference lose digits.
class SortedSamples {
 public:
  struct Sums {
    long double weight = 0.0L, first = 0.0L, second = 0.0L;  // Σw, Σw·u, Σw·u², u = x − ½
  };

  explicit SortedSamples(std::vector<WeightedSample> samples) : samples_(std::move(samples)) {
    std::erase_if(samples_, [](const WeightedSample& s) { return s.weight <= 0.0; });
    std::sort(samples_.begin(), samples_.end(),
              [](const WeightedSample& a, const WeightedSample& b) { return a.value < b.value; });
    sums_.resize(samples_.size() + 1);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const long double w = samples_[i].weight, u = samples_[i].value - 0.5L;
      sums_[i + 1] = {sums_[i].weight + w, sums_[i].first + w * u, sums_[i].second + w * u * u};
    }
  }

  std::size_t size() const { return samples_.size(); }
  double totalWeight() const { return double(sums_.back().weight); }

  // How many samples lie at or below `value`.
  std::size_t countUpTo(double value) const {
    return std::size_t(
        std::upper_bound(samples_.begin(), samples_.end(), value,
                         [](double v, const WeightedSample& s) { return v < s.value; }) -
        samples_.begin());
  }
  Sums sums(std::size_t begin, std::size_t end) const {
    return {sums_[end].weight - sums_[begin].weight, sums_[end].first - sums_[begin].first,
            sums_[end].second - sums_[begin].second};
  }
  // Of a range that is not empty. Rounding never takes it out of the range.
  double mean(std::size_t begin, std::size_t end) const {
    const Sums s = sums(begin, end);
    return std::clamp(double(s.first / s.weight + 0.5L), samples_[begin].value,
                      samples_[end - 1].value);
  }
  double squaredDistances(std::size_t begin, std::size_t end, double to) const {
    const Sums s = sums(begin, end);
    const long double u = to - 0.5L;
    return std::max(0.0, double(s.second - 2.0L * u * s.first + u * u * s.weight));
  }
  bool hasTwoValues(std::size_t begin, std::size_t end) const {
    return end > begin && samples_[begin].value < samples_[end - 1].value;
  }

 private:
  std::vector<WeightedSample> samples_;
  std::vector<Sums> sums_;
};

// Cluster k is the samples from ends[k] to ends[k + 1]: those nearest to split k, a sample half
// way belonging to the nearer one.
std::vector<std::size_t> assign(const SortedSamples& samples, const std::vector<double>& splits) {
  std::vector<std::size_t> ends{0};
  for (std::size_t k = 0; k + 1 < splits.size(); ++k)
    ends.push_back(std::max(ends.back(), samples.countUpTo(0.5 * (splits[k] + splits[k + 1]))));
  ends.push_back(samples.size());
  return ends;
}

double costOf(const SortedSamples& samples, const std::vector<double>& splits,
              const std::vector<std::size_t>& ends) {
  double sum = 0.0;
  for (std::size_t k = 0; k < splits.size(); ++k)
    sum += samples.squaredDistances(ends[k], ends[k + 1], splits[k]);
  return sum / samples.totalWeight();
}

// Takes split `dead`, which has no samples, out and divides the heaviest cluster that can be
// divided: both halves about its mean get their own mean as split. False where none can.
bool teleport(const SortedSamples& samples, std::vector<double>& splits,
              const std::vector<std::size_t>& ends, std::size_t dead) {
  std::size_t heaviest = splits.size();
  long double weight = 0.0L;
  for (std::size_t k = 0; k < splits.size(); ++k) {
    const long double w = samples.sums(ends[k], ends[k + 1]).weight;
    if (w > weight && samples.hasTwoValues(ends[k], ends[k + 1])) {
      heaviest = k;
      weight = w;
    }
  }
  if (heaviest == splits.size()) return false;
  const std::size_t begin = ends[heaviest], end = ends[heaviest + 1];
  const double mean = samples.mean(begin, end);
  // The samples below the mean and the rest: two values or more leave neither half empty.
  const std::size_t middle =
      std::clamp(samples.countUpTo(std::nextafter(mean, -std::numeric_limits<double>::infinity())),
                 begin + 1, end - 1);
  splits[heaviest] = samples.mean(begin, middle);
  splits[dead] = samples.mean(middle, end);
  std::sort(splits.begin(), splits.end());
  return true;
}

std::vector<double> uniformStart(int count) {
  std::vector<double> splits;
  for (int k = 1; k <= count; ++k) splits.push_back(double(k) / (count + 1));
  return splits;
}

}  // namespace

std::vector<WeightedSample> secondOccluderSamples(const DepthMap& map, WeightClamp clamp) {
  std::vector<WeightedSample> samples;
  if (map.width() < 2 || map.height() < 2) return samples;
  samples.reserve(std::size_t(map.width() - 1) * std::size_t(map.height() - 1));
  for (int y = 0; y + 1 < map.height(); ++y) {
    for (int x = 0; x + 1 < map.width(); ++x) {
      const std::array<double, 4> depths{map(x, y), map(x + 1, y), map(x, y + 1),
                                         map(x + 1, y + 1)};
      const double mean = 0.25 * (depths[0] + depths[1] + depths[2] + depths[3]);
      double variance = 0.0;
      for (double depth : depths) variance += 0.25 * (depth - mean) * (depth - mean);
      samples.push_back({mean + std::sqrt(variance), std::clamp(variance, clamp.low, clamp.high)});
    }
  }
  return samples;
}

LloydResult relax(std::vector<WeightedSample> unsorted, const LloydOptions& options) {
  const SortedSamples samples(std::move(unsorted));
  LloydResult result;
  result.splits = options.start.empty() ? uniformStart(options.splits) : options.start;
  std::vector<double>& splits = result.splits;
  if (splits.empty()) return result;
  const std::size_t count = splits.size();
  const std::size_t perIteration = options.movedPerIteration > 0
                                       ? std::min(count, std::size_t(options.movedPerIteration))
                                       : count;
  std::size_t next = 0;   // whose turn it is
  std::size_t still = 0;  // how many were looked at since anything moved
  while (result.iterations < options.maxIterations && still < count) {
    ++result.iterations;
    if (samples.size() == 0) {
      result.cost.push_back(0.0);
      break;
    }
    const std::vector<std::size_t> ends = assign(samples, splits);
    result.cost.push_back(costOf(samples, splits, ends));
    std::vector<double> moved = splits;
    bool teleported = false;
    for (std::size_t i = 0; i < perIteration && !teleported; ++i, next = (next + 1) % count) {
      if (ends[next] < ends[next + 1])
        moved[next] = samples.mean(ends[next], ends[next + 1]);
      else
        teleported = teleport(samples, splits, ends, next);
    }
    if (teleported) {
      ++result.teleports;
      still = 0;
    } else {
      still = moved == splits ? still + perIteration : 0;
      splits = moved;
    }
  }
  return result;
}

}  // namespace umbra
