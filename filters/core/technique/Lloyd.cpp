#include "filters/core/technique/Lloyd.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "filters/core/technique/SortedSamples.h"

namespace umbra {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The clamp keeps rounding from moving the mean out of the cluster's range.
double meanOf(const ClusterSums& cluster) {
  return std::clamp(double(cluster.first / cluster.weight + 0.5L), cluster.low, cluster.high);
}

double squaredDistances(const ClusterSums& cluster, double to) {
  const long double u = to - 0.5L;
  return std::max(0.0, double(cluster.second - 2.0L * u * cluster.first + u * u * cluster.weight));
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

Relaxation::Relaxation(const LloydOptions& options) : options_(options) {
  result_.splits = options.start.empty() ? uniformStart(options.splits) : options.start;
}

bool Relaxation::settled() const {
  if (division_) return false;
  return still_ >= result_.splits.size() || result_.iterations >= options_.maxIterations;
}

void Relaxation::resume() {
  const std::vector<double> splits = std::move(result_.splits);
  result_ = {.splits = splits};
  still_ = 0;
}

// A sample half way between two splits belongs to the nearer one.
std::vector<double> Relaxation::ends() const {
  std::vector<double> ends;
  for (std::size_t k = 0; k + 1 < result_.splits.size(); ++k) {
    if (division_ && division_->heaviest == k) ends.push_back(division_->end);
    ends.push_back(0.5 * (result_.splits[k] + result_.splits[k + 1]));
  }
  if (division_ && division_->heaviest + 1 == result_.splits.size()) ends.push_back(division_->end);
  return ends;
}

void Relaxation::take(std::span<const ClusterSums> clusters) {
  if (division_) return teleport(clusters);
  std::vector<double>& splits = result_.splits;
  const std::size_t count = splits.size();
  ++result_.iterations;
  long double weight = 0.0L;
  double distances = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    weight += clusters[k].weight;
    distances += squaredDistances(clusters[k], splits[k]);
  }
  result_.cost.push_back(weight > 0.0L ? distances / double(weight) : 0.0);
  if (!(weight > 0.0L)) {
    still_ = count;
    return;
  }
  const std::size_t turns = options_.movedPerIteration > 0
                                ? std::min(count, std::size_t(options_.movedPerIteration))
                                : count;
  std::vector<double> moved = splits;
  for (std::size_t i = 0; i < turns && !division_; ++i, next_ = (next_ + 1) % count) {
    if (clusters[next_].weight > 0.0L)
      moved[next_] = meanOf(clusters[next_]);
    else
      divide(clusters, next_);
  }
  if (division_) return;
  still_ = moved == splits ? still_ + turns : 0;
  splits = moved;
}

// Chooses the heaviest cluster that can be divided, at its mean: the samples below it and the rest.
// Two values or more leave neither half empty.
void Relaxation::divide(std::span<const ClusterSums> clusters, std::size_t dead) {
  std::optional<std::size_t> heaviest;
  for (std::size_t k = 0; k < clusters.size(); ++k)
    if (clusters[k].low < clusters[k].high &&
        (!heaviest || clusters[k].weight > clusters[*heaviest].weight))
      heaviest = k;
  if (!heaviest) return;
  const ClusterSums& cluster = clusters[*heaviest];
  division_ = {*heaviest, dead,
               std::clamp(std::nextafter(meanOf(cluster), -infinity), cluster.low,
                          std::nextafter(cluster.high, -infinity))};
}

// Both halves of the divided cluster get their own mean as split. Other samples than those that it
// was divided for may have left one empty: then nothing moves, and the next iteration looks again.
void Relaxation::teleport(std::span<const ClusterSums> clusters) {
  const ClusterSums &lower = clusters[division_->heaviest], &upper = *(&lower + 1);
  if (lower.weight > 0.0L && upper.weight > 0.0L) {
    result_.splits[division_->heaviest] = meanOf(lower);
    result_.splits[division_->dead] = meanOf(upper);
    std::sort(result_.splits.begin(), result_.splits.end());
    ++result_.teleports;
  }
  still_ = 0;
  division_.reset();
}

LloydResult relax(std::vector<WeightedSample> unsorted, const LloydOptions& options) {
  const SortedSamples samples(std::move(unsorted));
  Relaxation relaxation(options);
  while (!relaxation.settled()) relaxation.take(samples.clusters(relaxation.ends()));
  return relaxation.result();
}

}  // namespace umbra
