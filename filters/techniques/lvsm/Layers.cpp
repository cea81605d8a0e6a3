#include "filters/techniques/lvsm/Layers.h"

#include <string>

#include "filters/core/support/Error.h"
#include "filters/core/technique/Lloyd.h"

namespace umbra {
namespace {

// Depth. Only adapted splits are kept apart by it.
constexpr double smallestLayer = 1e-4;

void checkSplits(const std::vector<double>& splits, std::string_view id) {
  bool rising = splits.size() < std::size_t(largestLayerCount);
  double last = 0.0;
  for (double split : splits) {
    rising = rising && split > last && split < 1.0;
    last = split;
  }
  if (!rising)
    throw Error(ErrorKind::BadInput, std::string(id) + ".splits: '" + toText(splits) +
                                         "' is not right, it takes up to 15 depths between 0 and "
                                         "1 that rise strictly, such as 0.2:0.5:0.7");
}

}  // namespace

std::vector<Parameter> bindLayerParameters(std::vector<Parameter> parameters,
                                           LayerParameters& values, std::string_view id) {
  LayerParameters* bound = &values;
  for (Parameter& parameter : parameters) {
    const auto plain = parameter.put;
    if (parameter.name == "splits") {
      parameter.put = [bound, plain, id](const ParameterValue& value) {
        checkSplits(std::get<std::vector<double>>(value), id);
        plain(value);
        if (bound->splits.empty()) return;
        bound->placement = LayerPlacement::Manual;
        bound->layers = int(bound->splits.size()) + 1;
      };
    } else if (parameter.name == "layers" || parameter.name == "placement") {
      parameter.put = [bound, plain](const ParameterValue& value) {
        plain(value);
        if (bound->placement != LayerPlacement::Manual ||
            bound->layers != int(bound->splits.size()) + 1)
          bound->splits.clear();
      };
    }
  }
  return parameters;
}

int adaptedSplitCount(const LayerParameters& values) {
  return values.placement == LayerPlacement::Lloyd ? values.layers - 1 : 0;
}

std::vector<double> relaxedSplits(const LayerParameters& values, const DepthMap& map) {
  const int count = adaptedSplitCount(values);
  if (count == 0) return {};
  return relax(secondOccluderSamples(map), {.splits = count}).splits;
}

std::vector<double> keptApart(std::span<const double> found) {
  std::vector<double> splits(found.begin(), found.end());
  const std::size_t count = splits.size();
  for (std::size_t k = 0; k < count; ++k)
    splits[k] = std::max(splits[k], (k == 0 ? 0.0 : splits[k - 1]) + smallestLayer);
  for (std::size_t k = count; k-- > 0;)
    splits[k] = std::min(splits[k], (k + 1 == count ? 1.0 : splits[k + 1]) - smallestLayer);
  return splits;
}

Layering layeringOf(const LayerParameters& values, std::span<const double> adapted) {
  std::span<const double> splits;
  if (values.placement == LayerPlacement::Manual) splits = values.splits;
  if (values.placement == LayerPlacement::Lloyd && int(adapted.size()) + 1 == values.layers)
    splits = adapted;
  Layering layering;
  layering.count = splits.empty() ? values.layers : int(splits.size()) + 1;
  layering.overlap = values.overlap;
  for (int k = 1; k < layering.count; ++k)
    layering.bounds[k] = splits.empty() ? double(k) / layering.count : splits[k - 1];
  layering.bounds[layering.count] = 1.0;
  return layering;
}

std::vector<Uniform> layerUniforms(const Layering& layering) {
  std::vector<float> low(largestLayerCount), high(largestLayerCount), end(largestLayerCount);
  for (int i = 0; i < layering.count; ++i) {
    low[i] = float(layering.low(i));
    high[i] = float(layering.high(i));
    end[i] = float(layering.bounds[i + 1]);
  }
  return {{"umbra_layer_low", low}, {"umbra_layer_high", high}, {"umbra_layer_end", end}};
}

}  // namespace umbra
