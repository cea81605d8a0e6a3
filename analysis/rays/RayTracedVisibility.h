// The ray-traced reference: percentage-closer filtering with a shadow map of unlimited resolution.
// The difference between exact percentage-closer filtering and this is the map's error; the
// difference between a technique and exact percentage-closer filtering is the filter's.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "analysis/rays/CasterRays.h"
#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Region.h"

namespace umbra {

// A texel of the map is a square. Rays through n × n places of it, each in a cell of its own and no
// two in one row or column (Chiu, Shirley & Wang 1994, without their jitter), tell how much of it
// the light passes. Where one straight edge along an axis crosses the texel, the result is off by
// at most 1/(2n²).
//
// The rays of a block of texels are cast when the first of them is asked for. Their depths are
// stored, since frames of many pixels read every texel often. All functions may be called from many
// threads at once.
class RayTracedVisibility {
 public:
  static constexpr int largestSide = 8;

  // `cascades` are those of the frame as it was drawn, each with a map of `mapSize` texels a side.
  // `side` is n, 1 … largestSide. `cullFrontFaces` is the frame's Bias::cullFrontFaces.
  RayTracedVisibility(const Scene& scene, std::span<const Cascade> cascades, int mapSize,
                      bool cullFrontFaces, int side);

  // Σ w · (the part of the texel whose first hit lies at or behind `receiver`) over the taps.
  // Beyond the map's border the edge texel repeats, as in the map. Each of a texel's samples
  // represents the whole texel.
  double operator()(const Region& region, double receiver) const;

  // The largest n with which the rays of all texels of this many maps take at most 256 MiB. Small
  // texels need fewer rays.
  static int sideFor(int mapSize, int cascades);

 private:
  static constexpr int blockSide = 16;  // texels
  struct Block {
    std::once_flag cast;
    std::vector<float> depths;  // side² depths of each texel, ascending
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
