// Depth cut into layers, each with a linear warp of its own (Lauritzen 2008, §4.1): what layered
// variance shadow maps and the layered power CDF have in common.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "filters/core/maps/Image.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

inline constexpr int largestLayerCount = 16;

enum class LayerPlacement { Uniform, Manual, Lloyd };
inline constexpr std::array<std::string_view, 3> layerPlacementNames{"uniform", "manual", "lloyd"};

// The parameters of a layered technique. `splits` are the manual ones only, and they fix the number
// of layers: bindLayerParameters keeps the two in agreement.
struct LayerParameters {
  int layers = 4;
  LayerPlacement placement = LayerPlacement::Uniform;
  std::vector<double> splits;
  double overlap = 0.01;
};

// The fields of LayerParameters in P, which derives from it.
template <class P>
constexpr auto layerFields() {
  return std::tuple{
      Field<P, int>{&P::layers, "layers", "N", "", 1, largestLayerCount,
                    "Number of depth layers; another number drops the manual splits."},
      Field<P, LayerPlacement>{&P::placement, "placement", "", "", LayerPlacement::Uniform,
                               LayerPlacement::Lloyd,
                               "Where depth is split; manual is uniform until splits are given.",
                               Scale::Linear, layerPlacementNames},
      Field<P, std::vector<double>>{&P::splits, "splits", "s", "depth", 0.0, 1.0,
                                    "Manual splits, rising strictly between 0 and 1; they set "
                                    "placement to manual and layers to one more."},
      Field<P, double>{&P::overlap, "overlap", "δ", "depth", 0.0, 0.25,
                       "Half width of the zone around a split in which two layers are blended."}};
}

// Binds `parameters` to the technique `id` with these values, so that the three fields agree
// whichever is set: splits set the placement to manual and the number of layers to one more;
// another placement or number of layers drops the splits. Splits that do not rise strictly inside
// (0,1), or are more than 15, are refused with BadInput.
std::vector<Parameter> bindLayerParameters(std::vector<Parameter> parameters,
                                           LayerParameters& values, std::string_view id);

// The layers in use. Layer i, from 0, holds the depths in (bounds[i], bounds[i + 1]].
struct Layering {
  int count = 1;
  double overlap = 0.0;
  std::array<double, largestLayerCount + 1> bounds{0.0, 1.0};

  // The interval [p, q] that layer i covers: widened by the overlap, but not at 0 and 1 (§4.1.1).
  double low(int i) const { return i == 0 ? 0.0 : bounds[i] - overlap; }
  double high(int i) const { return i == count - 1 ? 1.0 : bounds[i + 1] + overlap; }

  // Lauritzen 2008, eq. 4.2: z to [0,1].
  double warp(int i, double z) const {
    return std::clamp((z - low(i)) / (high(i) - low(i)), 0.0, 1.0);
  }

  // The result of `visibilityIn(i)` for the layer that holds the receiver. Within the overlap of a
  // split (the nearest one, where there are two) the results for both its layers are blended
  // linearly (§4.1.3).
  template <class Visibility>
  double blended(double receiver, Visibility&& visibilityIn) const {
    int nearest = 0;  // the split between layers nearest − 1 and nearest, 0 for none
    for (int k = 1; k < count; ++k) {
      const double distance = std::abs(receiver - bounds[k]);
      if (distance < overlap && (!nearest || distance < std::abs(receiver - bounds[nearest])))
        nearest = k;
    }
    if (nearest) {
      const double farther = (receiver - bounds[nearest] + overlap) / (2.0 * overlap);
      return (1.0 - farther) * visibilityIn(nearest - 1) + farther * visibilityIn(nearest);
    }
    int holder = 0;
    while (holder + 1 < count && receiver > bounds[holder + 1]) ++holder;
    return visibilityIn(holder);
  }
};

// How many splits the values want Lloyd's relaxation to find.
int adaptedSplitCount(const LayerParameters& values);
// Finds those splits for `map` on the CPU; ascending.
std::vector<double> relaxedSplits(const LayerParameters& values, const DepthMap& map);
// Makes found splits into such as layers can have: ascending, inside (0,1), and at least 1e-4
// apart. A second occluder μ + σ, and with it a split, may lie beyond 1.
std::vector<double> keptApart(std::span<const double> found);

// The layers that the values describe. `adapted` is what keptApart gave. Uniform splits are taken
// where Lloyd's are asked for and there are none for this number of layers.
Layering layeringOf(const LayerParameters& values, std::span<const double> adapted);

// The uniforms of layered techniques' shaders, each float[16]: umbra_layer_low and umbra_layer_high
// are p and q of every layer, umbra_layer_end is the split that ends it.
std::vector<Uniform> layerUniforms(const Layering& layering);

}  // namespace umbra
