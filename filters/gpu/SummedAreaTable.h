// Summed-area tables of channels, by recursive doubling (Hensley et al. 2005, §3.1).
#pragma once

#include <span>
#include <string>

#include "filters/core/settings/FrameSettings.h"
#include "filters/gpu/gl/Program.h"
#include "filters/gpu/gl/Texture.h"

namespace umbra {

struct ChannelRange;

// Needs a current context (4.5 core) and leaves no program bound.
class SummedAreaTable {
 public:
  // Sums each layer of `channels` by itself. A sum of integers takes (stored − low) / span, clamped
  // to [0,1], in 65535 steps; `ranges` has one entry for each channel of one map, four to a layer,
  // and is repeated for the maps that follow. Nothing is read back.
  void build(const gl::Texture& channels, SatPrecision precision,
             std::span<const ChannelRange> ranges);

  // The table has one node more a side than the map has texels: node (x, y) is the sum of the
  // texels left of x and above y, as 32-bit integers or the bits of 32-bit floats. Node 0 of one
  // more row holds the values that were subtracted from each texel.
  const gl::Texture& texture() const { return table_; }
  // The bytes of the table of a square map of `size` texels a side, `texelBytes` a texel, with all
  // that it takes to make it.
  static std::size_t bytes(std::size_t texelBytes, int size);

  void releaseGraphicsResources();

 private:
  void findCentres(const gl::Texture& channels, GLenum format);
  void addUp(const gl::Texture& channels, SatPrecision precision,
             std::span<const ChannelRange> ranges, bool first, int stepX, int stepY);

  gl::ProgramCache programs_;
  gl::Texture table_, scratch_, centres_;
};

// The number by which SatRead.glsl and SatSums.comp.glsl know it.
int satPrecisionNumber(SatPrecision precision);

}  // namespace umbra
