#include "filters/gpu/bench/FrameCosts.h"

#include <algorithm>
#include <vector>

#include "filters/gpu/ChannelBaker.h"
#include "filters/gpu/bench/CostClock.h"

namespace umbra {
namespace {

constexpr std::size_t mostFrames = 3;
constexpr double longEnough = 1000.0;  // milliseconds

FrameCosts costOf(const std::vector<PassTime>& passes) {
  FrameCosts cost;
  for (const PassTime& pass : passes) {
    const bool shades = pass.pass == "shade" || pass.pass == "view";
    (shades ? cost.shadeMs : cost.bakeMs) += pass.milliseconds;
  }
  return cost;
}

// The middle one of an odd number, the lower of two.
double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

FrameCosts costOfFrames(ShadowRenderer& renderer) {
  renderer.setPassClock(drawsInSoftware() ? PassClock::Processor : PassClock::Gpu);
  renderer.render();
  std::vector<double> bakes, shades;
  for (double spent = 0.0; bakes.size() < mostFrames && spent < longEnough;) {
    renderer.forgetBake();
    renderer.render();
    const FrameCosts cost = costOf(renderer.passTimes());
    bakes.push_back(cost.bakeMs);
    shades.push_back(cost.shadeMs);
    spent += cost.bakeMs + cost.shadeMs;
  }
  renderer.setPassClock(PassClock::Gpu);
  return {medianOf(bakes), medianOf(shades)};
}

double bytesUsedPerTexel(const FrameSettings& settings, const Technique& technique) {
  const double texels = double(settings.map.size) * settings.map.size * settings.map.cascades.count;
  return double(textureBytes(settings, technique)) / texels;
}

}  // namespace umbra
