#include "analysis/Probe.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "filters/core/Prefilter.h"

namespace umbra {
namespace {

TechniqueResult resultOf(std::shared_ptr<const Technique> technique, const ProbeRequest& request,
                         const Probe& probe) {
  TechniqueResult result;
  result.channels =
      readChannels(request.map, *technique, request.kernel, request.format, request.read);
  result.visibility = technique->visibility({result.channels, probe.region}, probe.receiver);
  result.error = result.visibility - probe.reference;
  result.technique = std::move(technique);
  return result;
}

// The region's texels as (depth, weight), nearest to the light first.
std::vector<std::pair<double, double>> sortedByDepth(const Region& region) {
  std::vector<std::pair<double, double>> sorted;
  sorted.reserve(region.texels.size());
  for (const RegionTexel& texel : region.texels) sorted.emplace_back(texel.depth, texel.weight);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

// Σ w [z ≥ d] at every depth of `depths` (ascending) by one walk over the sorted texels.
std::vector<double> referenceCurve(const Region& region, const std::vector<double>& depths) {
  const auto sorted = sortedByDepth(region);
  // Summed from the far end, so that behind the last texel the sum is exactly 0.
  std::vector<double> atOrBehind(sorted.size() + 1, 0.0);
  for (std::size_t i = sorted.size(); i-- > 0;)
    atOrBehind[i] = atOrBehind[i + 1] + sorted[i].second;
  std::vector<double> curve;
  curve.reserve(depths.size());
  std::size_t blocking = 0;
  for (double depth : depths) {
    while (blocking < sorted.size() && sorted[blocking].first < depth) ++blocking;
    // With nothing in front every weight counts, however their sum was rounded.
    curve.push_back(blocking == 0 ? 1.0 : std::min(atOrBehind[blocking], 1.0));
  }
  return curve;
}

Histogram binned(std::span<const double> values, std::span<const double> weights, double low,
                 double high, int bins) {
  if (low == high) return {{low, high}, {1.0}};
  Histogram histogram;
  for (int i = 0; i <= bins; ++i) histogram.edges.push_back(std::lerp(low, high, double(i) / bins));
  histogram.weights.assign(bins, 0.0);
  const auto first = histogram.edges.begin() + 1, last = histogram.edges.end() - 1;
  for (std::size_t i = 0; i < values.size(); ++i) {
    // By the edges themselves, so that rounding never puts a value outside the bin it is drawn in;
    // the last bin is closed.
    histogram.weights[std::upper_bound(first, last, values[i]) - first] += weights[i];
  }
  return histogram;
}

}  // namespace

Probe takeProbe(const ProbeRequest& request) {
  Probe probe;
  probe.region = regionOf(request.map, request.kernel, request.read);
  probe.receiver = request.receiver;
  probe.statistics = statisticsOf(probe.region);
  probe.reference = referenceVisibility(probe.region, probe.receiver);
  for (const auto& technique : request.techniques) {
    const std::string refusal = technique->refusal(request.format);
    if (refusal.empty())
      probe.techniques.push_back(resultOf(technique, request, probe));
    else
      probe.refused.push_back({technique, refusal});
  }
  return probe;
}

Histogram histogramOf(const Region& region, int bins) {
  std::vector<double> depths, weights;
  for (const RegionTexel& texel : region.texels) {
    depths.push_back(texel.depth);
    weights.push_back(texel.weight);
  }
  const RegionStatistics s = statisticsOf(region);
  return binned(depths, weights, s.min, s.max, bins);
}

Histogram histogramOf(std::span<const double> values, std::span<const double> weights, int bins) {
  std::vector<double> counted, scaled;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    counted.push_back(values[i]);
    scaled.push_back(weights[i]);
  }
  if (counted.empty()) return {};
  const double total = std::accumulate(scaled.begin(), scaled.end(), 0.0);
  for (double& weight : scaled) weight /= total;
  const auto [low, high] = std::minmax_element(counted.begin(), counted.end());
  return binned(counted, scaled, *low, *high, bins);
}

EmpiricalCdf empiricalCdfOf(const Region& region) {
  EmpiricalCdf cdf;
  double sum = 0.0;
  for (const auto& [depth, weight] : sortedByDepth(region)) {
    sum += weight;
    if (cdf.depth.empty() || cdf.depth.back() != depth) {
      cdf.depth.push_back(depth);
      cdf.cumulative.push_back(sum);
    } else {
      cdf.cumulative.back() = sum;
    }
  }
  if (!cdf.cumulative.empty()) cdf.cumulative.back() = 1.0;  // whatever the sum was rounded to
  return cdf;
}

Curves curvesOf(const Probe& probe, int samples) {
  Curves curves;
  curves.depth.reserve(samples);
  for (int i = 0; i < samples; ++i)
    curves.depth.push_back(samples > 1 ? double(i) / (samples - 1) : 0.0);
  curves.reference = referenceCurve(probe.region, curves.depth);
  for (const TechniqueResult& result : probe.techniques) {
    std::vector<double>& curve = curves.techniques.emplace_back();
    curve.reserve(samples);
    const Fetch fetch{result.channels, probe.region};
    for (double depth : curves.depth) curve.push_back(result.technique->visibility(fetch, depth));
  }
  return curves;
}

}  // namespace umbra
