// The second truth: percentage-closer filtering with a shadow map of unlimited resolution. What
// exact percentage-closer filtering differs from it is the map's error, what a technique differs
// from exact percentage-closer filtering is the filter's.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "analysis/rays/CasterRays.h"
#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Region.h"

namespace umbra {

// A texel of the map is a square; rays through n × n places of it, each in a cell of its own and no
// two in one row or column (Chiu, Shirley & Wang 1994, without their jitter), tell how much of it
// the light passes: off by at most 1/(2n²) where one straight edge along an axis crosses it.
//
// The rays of a block of texels are cast when the first of them is asked for, and kept: frames of
// many pixels read every texel often. All functions may be called from many threads at once.
class RayTracedVisibility {
 public:
  static constexpr int largestSide = 8;

  // `cascades` as the frame was drawn, each with a map of `mapSize` texels a side. `side` is n,
  // 1 … largestSide. Bias::cullFrontFaces as in the frame.
  RayTracedVisibility(const Scene& scene, std::span<const Cascade> cascades, int mapSize,
                      bool cullFrontFaces, int side);

  // Σ w · (part of the texel whose first hit lies at or behind `receiver`) over the taps; beyond
  // the map's end the edge texel repeats, as in the map. Several samples of a texel all stand for
  // the whole texel.
  double operator()(const Region& region, double receiver) const;

  // The largest n with which the rays of all texels of this many maps take 256 MiB at most: small
  // texels need fewer.
  static int sideFor(int mapSize, int cascades);

 private:
  static constexpr int blockSide = 16;  // texels
  struct Block {
    std::once_flag cast;
    std::vector<float> depths;  // side² of each texel, ascending
  };
  struct Map {
    LightRays rays;
    std::unique_ptr<Block[]> blocks;
  };

  std::span<const float> depthsOf(const RegionTexel& texel) const;
  void cast(const Map& map, int blockX, int blockY, Block& block) const;

  CasterRays rays_;
  int size_, side_, blocksAcross_;
  std::vector<Map> maps_;
};

}  // namespace umbra
