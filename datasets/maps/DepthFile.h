// Depth maps in files from anywhere.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/maps/DepthProjection.h"
#include "datasets/maps/DepthScale.h"
#include "filters/core/maps/Image.h"

namespace umbra {

// What becomes of a value that is no depth: one that is not finite, or beyond the range.
struct DepthMiss {
  enum class Kind {
    Error,  // it is refused
    Clamp,  // it becomes the nearest bound; NaN the far one
    Value   // see `value`
  };

  Kind kind = Kind::Error;
  // A value that is itself no depth, or the near bound, marks texels that saw nothing, which become
  // the far bound; other wrong values are refused. A value within the range stands in for all wrong
  // ones.
  double value = 0.0;

  // NaN is the same as NaN.
  bool operator==(const DepthMiss& other) const;
};
// "error", "clamp" or a number such as "1e10", "inf" or "nan". Throws BadInput that begins with
// `where`.
DepthMiss depthMissFrom(std::string_view text, std::string_view where);
std::string toText(const DepthMiss& miss);

// How the values of a file are understood.
struct DepthImport {
  std::string channel;               // "" is Z, else the only one
  double atZero = 0.0, atOne = 1.0;  // the file's values that become window depth 0 and 1
  DepthProjection projection;
  DepthMiss miss;

  // The file's values of the near plane, and of the far one or of infinity.
  double nearValue() const { return projection.isReversed() ? atOne : atZero; }
  double farValue() const { return projection.isReversed() ? atZero : atOne; }

  bool operator==(const DepthImport&) const = default;
};

struct DepthFile {
  DepthMap map;  // linear, in [0, 1]
  DepthScale scale;
  int originX = 0, originY = 0;    // the first texel's coordinates in the file's own count
  std::vector<std::string> notes;  // one sentence for each doubtful reading
};

// How a refusal for wrong texels ends: what the command line offers against it.
inline constexpr std::string_view depthMissHint =
    "; --depth-miss clamp would take the nearest bound, --depth-miss VALUE names the value of "
    "texels "
    "that saw nothing";

// Reads an OpenEXR file (half, float or whole numbers, tiles or scan lines, several parts), a PFM,
// or a NumPy array, in double. A bound counts as the number that the file can hold. Throws BadInput
// that names the file and what is wrong: the channels that there are with their ranges, or the
// texels of values that are no depths, in the file's own count, with what DepthMiss would do.
DepthFile readDepth(const std::filesystem::path& file, const DepthImport& import);
// The map of a file without a projection.
DepthMap readDepthFile(const std::filesystem::path& file, const std::string& channel = "",
                       double atZero = 0.0, double atOne = 1.0);

// `path:CHANNEL` split at the last colon that follows ".exr"; the channel may be absent.
std::pair<std::filesystem::path, std::string> splitDepthArgument(const std::string& argument);

}  // namespace umbra
