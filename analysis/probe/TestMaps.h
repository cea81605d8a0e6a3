// Depth maps and techniques for the tests of the analysis.
#pragma once

#include <memory>
#include <random>
#include <vector>

#include "filters/core/maps/Image.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {

// Layers with noise and, here and there, equal depths: what regions of real maps look like.
inline DepthMap randomMap(int width, int height, unsigned seed) {
  DepthMap map(width, height);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (double& depth : map.values()) {
    const double layer = 0.2 + 0.3 * double(random() % 3);
    depth = random() % 4 == 0 ? layer : std::min(1.0, layer + 0.1 * uniform(random));
  }
  return map;
}

inline std::vector<std::shared_ptr<const Technique>> everyTechnique(const DepthMap& map) {
  const TechniqueCatalogue catalogue = allTechniques();
  std::vector<std::shared_ptr<const Technique>> techniques;
  for (const Technique* technique : catalogue.all()) {
    std::shared_ptr<Technique> copy = technique->clone();
    copy->adapt(map);
    techniques.push_back(std::move(copy));
  }
  return techniques;
}

}  // namespace umbra
