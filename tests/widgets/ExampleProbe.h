// A map, a region and a probe whose figures are known.
#pragma once

#include <memory>

#include "analysis/probe/Probe.h"
#include "tests/widgets/ExampleTechnique.h"

namespace umbra {

// Every texel holds (x + y · width) / texels: no two are alike.
inline Image<float> numberedMap(int width, int height) {
  Image<float> map(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) map(x, y) = float(x + y * width) / float(width * height);
  return map;
}

inline Region regionAround(int x, int y, int radius) {
  DepthMap map(64, 64, 1, 0.5);
  return regionAtTexel(map, Kernel{KernelShape::Box, radius}, x, y);
}

inline TechniqueResult exampleResult(std::string_view id, std::string_view title,
                                     std::string_view colour, double visibility, double error) {
  TechniqueResult result;
  result.technique = std::make_shared<ExampleTechnique>(id, title, colour);
  result.visibility = visibility;
  result.error = error;
  return result;
}

inline Probe exampleProbe() {
  Probe probe;
  probe.region = regionAround(12, 8, 5);
  probe.receiver = 0.78;
  probe.statistics = {0.4977, 0.27099, 0.02328, 0.257, 0.643, 1.653};
  probe.reference = 0.0;
  probe.techniques = {
      exampleResult("pcf", "PCF (truth)", "#1f2933", 0.0, 0.0),
      exampleResult("vsm", "Variance (VSM)", "#2563c9", 0.2264, 0.2264),
      exampleResult("csm", "Convolution (CSM)", "#b7791f", 0.0, -0.0312),
      exampleResult("layered-power-cdf", "Layered power CDF", "#7c3aed", 0.5, -1.0)};
  probe.techniques[1].gpu = 0.2262;
  return probe;
}

}  // namespace umbra
