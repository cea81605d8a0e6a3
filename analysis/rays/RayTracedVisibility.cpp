#include "analysis/rays/RayTracedVisibility.h"

#include <algorithm>
#include <cassert>

namespace umbra {

RayTracedVisibility::RayTracedVisibility(const Scene& scene, std::span<const Cascade> cascades,
                                         int mapSize, bool cullFrontFaces, int side)
    : rays_(scene, cullFrontFaces),
      size_(mapSize),
      side_(side),
      blocksAcross_((mapSize + blockSide - 1) / blockSide) {
  assert(side >= 1 && side <= largestSide);
  const std::size_t blocks = std::size_t(blocksAcross_) * std::size_t(blocksAcross_);
  for (const Cascade& cascade : cascades)
    maps_.push_back({rays_.raysOf(cascade.frame), std::make_unique<Block[]>(blocks)});
}

int RayTracedVisibility::sideFor(int mapSize, int cascades) {
  constexpr double most = 256.0 * 1024 * 1024 / sizeof(float);
  const double texels = double(mapSize) * mapSize * cascades;
  int side = largestSide;
  while (side > 1 && texels * side * side > most) --side;
  return side;
}

void RayTracedVisibility::cast(const Map& map, int blockX, int blockY, Block& block) const {
  const int count = side_ * side_;
  block.depths.resize(std::size_t(blockSide * blockSide) * count);
  for (int texel = 0; texel < blockSide * blockSide; ++texel) {
    const int x = blockX * blockSide + texel % blockSide;
    const int y = blockY * blockSide + texel / blockSide;
    if (x >= size_ || y >= size_) continue;  // blocks at the map's end are not full
    float* depths = &block.depths[std::size_t(texel) * count];
    for (int i = 0; i < count; ++i) {
      const int column = i % side_, row = i / side_;
      // The place within its cell is given by the other index, so that every place has its own
      // column and row.
      const double dx = (column + (row + 0.5) / side_) / side_;
      const double dy = (row + (column + 0.5) / side_) / side_;
      depths[i] = float(rays_.depth(map.rays, (x + dx) / size_, (y + dy) / size_));
    }
    std::sort(depths, depths + count);
  }
}

std::span<const float> RayTracedVisibility::depthsOf(const RegionTexel& texel) const {
  const Map& map = maps_[texel.cascade];
  const int blockX = texel.x / blockSide, blockY = texel.y / blockSide;
  Block& block = map.blocks[blockY * blocksAcross_ + blockX];
  std::call_once(block.cast, [&] { cast(map, blockX, blockY, block); });
  const std::size_t count = std::size_t(side_) * side_;
  const std::size_t index = std::size_t(texel.y % blockSide) * blockSide + texel.x % blockSide;
  return std::span(block.depths).subspan(index * count, count);
}

double RayTracedVisibility::operator()(const Region& region, double receiver) const {
  double visibility = 0.0;
  for (const RegionTexel& texel : region.texels) {
    const std::span<const float> depths = depthsOf(texel);
    const auto lit = depths.end() - std::lower_bound(depths.begin(), depths.end(), receiver);
    visibility += texel.weight * double(lit) / double(depths.size());
  }
  return std::min(visibility, 1.0);  // the weights' sum is rounded
}

}  // namespace umbra
