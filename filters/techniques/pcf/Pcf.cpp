#include "filters/techniques/pcf/Pcf.h"

#include <algorithm>
#include <limits>

#include "Pcf_glsl.h"
#include "Pcf_md.h"
#include "filters/core/prefilter/ErrorShares.h"
#include "filters/core/support/Text.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra::pcf {
namespace {

// The region's texels by their place. Places beyond them lie beyond the map, where its edge
// repeats, which is among them.
class TexelsByPlace {
 public:
  explicit TexelsByPlace(const Region& region) : region_(region) {
    int right = 0, bottom = 0;
    left_ = top_ = std::numeric_limits<int>::max();
    for (const RegionTexel& texel : region.texels) {
      left_ = std::min(left_, texel.x);
      top_ = std::min(top_, texel.y);
      right = std::max(right, texel.x);
      bottom = std::max(bottom, texel.y);
    }
    firstTap_ = Image<int>(right - left_ + 1, bottom - top_ + 1, 1, -1);
    for (std::size_t i = 0; i < region.texels.size(); i += std::size_t(region.samples))
      firstTap_(region.texels[i].x - left_, region.texels[i].y - top_) = int(i);
  }

  // The part of the texel's samples at or behind the receiver.
  double closer(int x, int y, double receiver) const {
    const int tap = firstTap_(std::clamp(x - left_, 0, firstTap_.width() - 1),
                              std::clamp(y - top_, 0, firstTap_.height() - 1));
    if (tap < 0) return receiver <= region_.nearestDepth ? 1.0 : 0.0;
    int lit = 0;
    for (int i = 0; i < region_.samples; ++i) lit += region_.texels[tap + i].depth >= receiver;
    return double(lit) / region_.samples;
  }

 private:
  const Region& region_;
  int left_ = 0, top_ = 0;
  Image<int> firstTap_;
};

template <class Record>
double comparedDisc(const Region& region, int taps, double receiver, const Record& record) {
  record("z_r", "receiver's depth, biased", "", receiver);
  const TexelsByPlace texels(region);
  const std::vector<double> kernel = region.kernel.weights();
  const int radius = region.kernel.effectiveRadius();
  const auto weightAt = [&](int offset) {
    return std::abs(offset) <= radius ? kernel[std::size_t(offset + radius)] : 0.0;
  };
  const bool even = region.kernel.shape != KernelShape::Gaussian;
  double lit = 0.0, all = 0.0;
  for (int tap = 0; tap < taps; ++tap) {
    const auto [dx, dy] = tapOffset(tap, region.x, region.y, region.reachX, region.reachY);
    const double weight = even ? 1.0 : weightAt(dx) * weightAt(dy);
    lit += weight * texels.closer(region.x + dx, region.y + dy, receiver);
    all += weight;
  }
  record("n", "taps of the disc", "", taps);
  record("W", "their weight", "Σ w_i", all);
  record("W_lit", "weight of those at or behind the receiver", "Σ w_i [z_i ≥ z_r]", lit);
  return record("v", "visibility", "W_lit / W", std::min(lit / all, 1.0));
}

template <class Record>
double comparedAll(const Region& region, double receiver, const Record& record) {
  record("z_r", "receiver's depth, biased", "", receiver);
  record("n", "taps of the region", "", double(region.texels.size()));
  return record("v", "visibility: the weight of taps at or behind the receiver",
                "Σ w_i [z_i ≥ z_r]", referenceVisibility(region, receiver));
}

template <class Record>
double compared(const PcfParameters& values, const Region& region, double receiver,
                const Record& record) {
  return values.taps == Taps::All ? comparedAll(region, receiver, record)
                                  : comparedDisc(region, values.poissonTaps, receiver, record);
}

}  // namespace

const TechniqueInfo& Pcf::info() const {
  static constexpr TechniqueInfo info{
      .id = "pcf",
      .title = "Percentage closer (PCF)",
      .citation = "Reeves, Salesin & Cook 1987",
      .summary =
          "Stores depth and compares every texel of the region: exact, but not prefilterable.",
      .formula = "v = Σ w_i [z_i ≥ z_r]",
      .order = 10,
      .prefilterable = false,
      // The largest disc has 64 products of two rounded weights, summed twice, and a division.
      .roundings = 2 * (64 + 2) + 2,
      .colour = "#1f2933"};
  return info;
}

void Pcf::encode(double z, std::span<double> channels) const {
  channels[0] = z;
}

double Pcf::visibility(const Fetch& fetch, double receiver) const {
  return compared(values, fetch.region, receiver, Unrecorded());
}

Trace Pcf::explain(const Fetch& fetch, double receiver) const {
  Trace trace;
  compared(values, fetch.region, receiver, TraceRecorder(trace));
  ErrorShares shares(trace, fetch, receiver);
  shares.rest(ErrorCause::Sampling, "n",
              std::to_string(values.poissonTaps) + " points stand for the region's " +
                  std::to_string(fetch.region.texels.size()) +
                  " taps; how many of them fall on occluders depends on how the disc is turned.");
  shares.decide(values.taps == Taps::All
                    ? "every tap is compared, and the answers are averaged: that is the definition."
                    : "as many points of the disc are blocked as of the region.");
  return trace;
}

std::string_view Pcf::glsl() const {
  static const std::string text = discTables() + Pcf_glsl;
  return text;
}
std::string_view Pcf::page() const {
  return Pcf_md;
}

void addTo(TechniqueCatalogue& catalogue) {
  catalogue.add(std::make_unique<Pcf>());
}

}  // namespace umbra::pcf
