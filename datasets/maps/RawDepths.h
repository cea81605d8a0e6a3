// What a depth file holds before anyone says how it is read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/maps/Raster.h"

namespace umbra {

struct RawDepths {
  static constexpr int bins = 64;

  // One end of the sorted finite values.
  struct End {
    double value = 0.0;      // the outermost one
    double next = 0.0;       // the outermost one that differs from it; itself where there is none
    std::size_t texels = 0;  // that hold `value`
    bool apart = false;      // stands so far from all others that it is perhaps no depth
  };

  std::vector<std::string> channels;  // that one can name; none where the format names none
  RasterInfo info;
  std::size_t finite = 0, notNumbers = 0, plusInfinite = 0, minusInfinite = 0;  // texels
  // Texels in [0, 1] that tell projections apart; 0 and 1 themselves are no part of the tenths.
  std::size_t zeros = 0, inLowestTenth = 0, inHighestTenth = 0, ones = 0;
  End lowest, highest;              // where any value is finite
  double low = 0.0, high = 0.0;     // the finite values but ends that stand apart
  std::vector<std::size_t> counts;  // texels from low to high, in bins of equal width
};

// Reads the file twice, and needs no memory for its values. Throws BadInput as readDepth does, but
// for no value.
RawDepths readRawDepths(const std::filesystem::path& file, const std::string& channel);

}  // namespace umbra
