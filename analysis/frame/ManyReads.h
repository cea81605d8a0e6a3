// Many reads of one map. Each gives what a probe would; for a prefilterable technique the cost does
// not grow with the kernel.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "filters/core/maps/Image.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

struct MapRead {
  double u = 0.0, v = 0.0;  // in [0,1] from the map's top-left corner, v down
  double receiver = 0.0;    // z_r, biased, [0,1]
};

struct ReadVisibility {
  double visibility = 1.0;  // by the technique
  double reference = 1.0;   // the truth over the same region
};

struct ReadSubject {
  const DepthMap& map;
  const Technique& technique;  // parameters set, adapted to the map
  Kernel kernel;
  // Point, bilinear or summed area; a summed area's box is as wide as the kernel's window.
  ReadFilter filter = ReadFilter::Bilinear;
  StorageFormat format = StorageFormat::Float;
  // What is true over a region at a receiver depth, where it is not exact percentage-closer
  // filtering; called from many threads.
  std::function<double(const Region& region, double receiver)> truth;
};

// Gives one result for each read, in their order. Works on every core. `progress` is called on the
// calling thread alone with the part that is done, 0 … 1; an exception that it throws ends the
// work.
std::vector<ReadVisibility> evaluateReads(const ReadSubject& subject,
                                          std::span<const MapRead> reads,
                                          const std::function<void(double)>& progress);

}  // namespace umbra
