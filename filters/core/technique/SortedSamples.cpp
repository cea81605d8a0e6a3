#include "filters/core/technique/SortedSamples.h"

#include <algorithm>
#include <utility>

namespace umbra {

SortedSamples::SortedSamples(std::vector<WeightedSample> samples) : samples_(std::move(samples)) {
  std::erase_if(samples_, [](const WeightedSample& s) { return s.weight <= 0.0; });
  std::sort(samples_.begin(), samples_.end(),
            [](const WeightedSample& a, const WeightedSample& b) { return a.value < b.value; });
  sums_.resize(samples_.size() + 1);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const long double w = samples_[i].weight, u = samples_[i].value - 0.5L;
    const Sums& s = sums_[i];
    sums_[i + 1] = {s.weight + w, s.first + w * u, s.second + w * u * u};
  }
}

std::vector<ClusterSums> SortedSamples::clusters(std::span<const double> ends) const {
  std::vector<ClusterSums> clusters;
  std::size_t begin = 0;
  for (double end : ends) {
    const std::size_t next = std::max(begin, countUpTo(end));
    clusters.push_back(sums(begin, next));
    begin = next;
  }
  clusters.push_back(sums(begin, samples_.size()));
  return clusters;
}

// The cost that the first iteration of a relaxation finds when it starts from `splits`.
double SortedSamples::cost(std::span<const double> splits) const {
  if (splits.empty() || empty()) return 0.0;
  Relaxation relaxation({.splits = int(splits.size()),
                         .maxIterations = 1,
                         .start = std::vector<double>(splits.begin(), splits.end())});
  relaxation.take(clusters(relaxation.ends()));
  return relaxation.result().cost.front();
}

std::size_t SortedSamples::countUpTo(double value) const {
  return std::size_t(
      std::upper_bound(samples_.begin(), samples_.end(), value,
                       [](double v, const WeightedSample& s) { return v < s.value; }) -
      samples_.begin());
}

ClusterSums SortedSamples::sums(std::size_t begin, std::size_t end) const {
  if (begin == end) return {};
  return {sums_[end].weight - sums_[begin].weight, sums_[end].first - sums_[begin].first,
          sums_[end].second - sums_[begin].second, samples_[begin].value, samples_[end - 1].value};
}

}  // namespace umbra
