#include "analysis/probe/Probe.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/Composition.h"

namespace umbra {
namespace {

bool nextIsHeavier(const SeamPart& seam) {
  return seam.weight > 0.5;
}

TechniqueResult evaluate(std::shared_ptr<const Technique> technique, const ProbeRequest& request,
                         const Probe& probe) {
  TechniqueResult result;
  result.channels =
      readChannels(request.map, *technique, request.kernel, request.format, request.read);
  if (request.seam) {
    result.lighterChannels = readChannels(request.seam->map, *technique, request.kernel,
                                          request.format, request.seam->read);
    if (nextIsHeavier(*request.seam)) std::swap(result.channels, result.lighterChannels);
  }
  result.visibility = visibilityOf(*technique, probe, result, probe.receiver);
  result.error = result.visibility - probe.reference;
  result.technique = std::move(technique);
  return result;
}

Region regionIn(const DepthMap& map, const Kernel& kernel, const ReadPoint& read, int cascade) {
  Region region = regionOf(map, kernel, read);
  for (RegionTexel& texel : region.texels) texel.cascade = cascade;
  return region;
}

// Computes both regions, and their union about the place in the request's own cascade.
void probeSeam(const ProbeRequest& request, Probe& probe) {
  const SeamPart& seam = *request.seam;
  Region next = regionIn(seam.map, request.kernel, seam.read, request.cascade + 1);
  probe.seam.emplace();
  probe.seam->weight = std::min(seam.weight, 1.0 - seam.weight);
  probe.seam->heavier = probe.region;
  probe.seam->lighter = next;
  if (nextIsHeavier(seam)) std::swap(probe.seam->heavier, probe.seam->lighter);
  for (RegionTexel& texel : probe.region.texels) texel.weight *= 1.0 - seam.weight;
  for (RegionTexel& texel : next.texels) {
    texel.weight *= seam.weight;
    probe.region.texels.push_back(texel);
  }
}

// The region's texels as (depth, weight), nearest to the light first.
std::vector<std::pair<double, double>> sortedByDepth(const Region& region) {
  std::vector<std::pair<double, double>> sorted;
  sorted.reserve(region.texels.size());
  for (const RegionTexel& texel : region.texels) sorted.emplace_back(texel.depth, texel.weight);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

// Computes Σ w [z ≥ d] at every depth of `depths` (ascending) in one walk over the sorted texels.
std::vector<double> referenceCurve(const Region& region, const std::vector<double>& depths) {
  const auto sorted = sortedByDepth(region);
  // The sum starts at the far end, so that behind the last texel it is exactly 0.
  std::vector<double> atOrBehind(sorted.size() + 1, 0.0);
  for (std::size_t i = sorted.size(); i-- > 0;)
    atOrBehind[i] = atOrBehind[i + 1] + sorted[i].second;
  std::vector<double> curve;
  curve.reserve(depths.size());
  std::size_t blocking = 0;
  for (double depth : depths) {
    while (blocking < sorted.size() && sorted[blocking].first < depth) ++blocking;
    // With nothing in front all weights count, and their sum is 1 however it was rounded.
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
    // The bin is found by the edges themselves, so that rounding never puts a value outside the bin
    // in which it is drawn; the last bin is closed.
    histogram.weights[std::upper_bound(first, last, values[i]) - first] += weights[i];
  }
  return histogram;
}

}  // namespace

Probe takeProbe(const ProbeRequest& request) {
  Probe probe;
  probe.region = regionIn(request.map, request.kernel, request.read, request.cascade);
  probe.receiver = request.receiver;
  if (request.seam) probeSeam(request, probe);
  probe.statistics = statisticsOf(probe.region);
  // References are mixed as a technique's visibilities are, so that percentage-closer filtering has
  // no error.
  probe.reference = probe.seam ? std::lerp(referenceVisibility(probe.seam->heavier, probe.receiver),
                                           referenceVisibility(probe.seam->lighter, probe.receiver),
                                           probe.seam->weight)
                               : referenceVisibility(probe.region, probe.receiver);
  FrameSettings frame;
  frame.map.format = request.format;
  frame.kernel = request.kernel;
  frame.read.filter = request.read.filter;
  frame.read.satPrecision = request.satPrecision;
  for (const auto& technique : request.techniques) {
    const std::string refusal = whyImpossible(frame, *technique);
    if (refusal.empty())
      probe.techniques.push_back(evaluate(technique, request, probe));
    else
      probe.refused.push_back({technique, refusal});
  }
  return probe;
}

const TechniqueResult* resultOf(const Probe& probe, std::string_view id) {
  const auto found = std::find_if(
      probe.techniques.begin(), probe.techniques.end(),
      [&](const TechniqueResult& result) { return result.technique->info().id == id; });
  return found == probe.techniques.end() ? nullptr : &*found;
}

Fetch fetchOf(const Probe& probe, const TechniqueResult& result) {
  return {result.channels, probe.seam ? probe.seam->heavier : probe.region};
}

double visibilityOf(const Technique& technique, const Probe& probe, const TechniqueResult& result,
                    double receiver) {
  const double visibility = technique.visibility(fetchOf(probe, result), receiver);
  if (!probe.seam) return visibility;
  const Fetch lighter{result.lighterChannels, probe.seam->lighter};
  return std::lerp(visibility, technique.visibility(lighter, receiver), probe.seam->weight);
}

Region ownRegion(const Probe& probe) {
  Region own = probe.region;
  if (probe.seam)
    std::erase_if(own.texels, [cascade = own.texels.front().cascade](const RegionTexel& texel) {
      return texel.cascade != cascade;
    });
  return own;
}

ReadPoint readInCascade(const ReadPoint& read, const Cascade& from, const Cascade& to,
                        const Kernel& kernel) {
  ReadPoint there = read;
  there.u = std::clamp(to.u(from.left + from.side * read.u), 0.0, 1.0);
  there.v = std::clamp(to.v(from.top + from.side * read.v), 0.0, 1.0);
  there.footprint.x *= from.side / to.side;
  there.footprint.y *= from.side / to.side;
  if (read.filter == ReadFilter::SummedArea) {
    const double least = 2.0 * kernel.effectiveRadius() + 1.0, most = ReadSettings::largestSatWidth;
    there.footprint.x = std::clamp(there.footprint.x, least, most);
    there.footprint.y = std::clamp(there.footprint.y, least, most);
  }
  return there;
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
  if (!cdf.cumulative.empty()) cdf.cumulative.back() = 1.0;  // the sum was rounded
  return cdf;
}

Curves curvesOf(const Probe& probe, int samples, const std::function<void()>& eachStep) {
  Curves curves;
  curves.depth.reserve(samples);
  for (int i = 0; i < samples; ++i)
    curves.depth.push_back(samples > 1 ? double(i) / (samples - 1) : 0.0);
  curves.reference = referenceCurve(probe.region, curves.depth);
  for (const TechniqueResult& result : probe.techniques) {
    std::vector<double>& curve = curves.techniques.emplace_back();
    curve.reserve(samples);
    for (int i = 0; i < samples; ++i) {
      if (eachStep && i % 1024 == 0) eachStep();
      curve.push_back(visibilityOf(*result.technique, probe, result, curves.depth[i]));
    }
  }
  return curves;
}

}  // namespace umbra
