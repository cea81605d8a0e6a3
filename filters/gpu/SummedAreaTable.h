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

  // One node more a side than the map has texels: node (x, y) is the sum of the texels left of x
  // and above y. 32-bit integers, or the bits of 32-bit floats. A last row more holds what was
  // subtracted from each texel, at its node 0.
  const gl::Texture& texture() const { return table_; }
  // Of so many channels on maps of so many texels a side: the table and what it is made with.
  static std::size_t bytes(std::size_t texelBytes, int size);

  void releaseGraphicsResources();

 private:
  void findCentres(const gl::Texture& channels, GLenum format);
  void addUp(const gl::Texture& channels, SatPrecision precision,
             std::span<const ChannelRange> ranges, bool first, int stepX, int stepY);

  gl::ProgramCache programs_;
  gl::Texture table_, scratch_, centres_;
};

// As SatRead.glsl and SatSums.comp.glsl count them.
int satPrecisionNumber(SatPrecision precision);

}  // namespace umbra
