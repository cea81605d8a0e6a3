#include "filters/core/technique/Composition.h"

#include <algorithm>

namespace umbra {
namespace {

std::string whyNotSummed(const FrameSettings& frame, const Technique& technique) {
  if (frame.kernel.shape == KernelShape::Gaussian)
    return "filter sat: a summed-area table averages boxes, not a Gaussian; take the box kernel";
  if (!technique.info().prefilterable) return {};  // reads the box's own texels
  const std::string id(technique.info().id);
  const std::vector<Channel> channels = technique.channels();
  const bool onlyMeans = std::all_of(channels.begin(), channels.end(), [](const Channel& channel) {
    return channel.reduction == Reduction::Mean;
  });
  if (!onlyMeans)
    return "filter sat: a table of sums has no minima and maxima, which " + id +
           " needs; take trilinear or anisotropic";
  if (frame.read.satPrecision == SatPrecision::Integer &&
      !technique.refusal(StorageFormat::Unorm16).empty())
    return "sat-precision integer: the channels of " + id +
           " do not fit a fixed-point range; take centred";
  return {};
}

}  // namespace

std::string whyImpossible(const FrameSettings& frame, const Technique& technique) {
  const std::string refusal = technique.refusal(frame.map.format);
  if (!refusal.empty()) return refusal;
  return frame.read.filter == ReadFilter::SummedArea ? whyNotSummed(frame, technique)
                                                     : std::string();
}

std::string whyInexact(const FrameSettings& frame, const Technique& technique) {
  // Channels without a fixed range span many powers of e; MSM's and VSM's are within [0,1].
  if (frame.read.filter != ReadFilter::SummedArea || !technique.info().prefilterable ||
      technique.refusal(StorageFormat::Unorm16).empty())
    return {};
  return "filter sat: 32-bit sums over the whole map lose the small ones of its exponentials, so "
         "lit ground may turn dark and shadows light (compare tells by how much); take bilinear, "
         "trilinear or anisotropic";
}

}  // namespace umbra
