// What a stored channel may be instead of the technique's own one, and what it would hold then.
#pragma once

#include <string>

#include "filters/core/maps/Image.h"
#include "filters/core/settings/Kernel.h"
#include "filters/core/settings/StorageFormat.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// What a channel may hold instead of the technique's own quantity.
enum class StoredQuantity {
  Own,
  AfterFilter,  // the filtered depth is encoded, where the encoded depth should be filtered
  Depth,        // the filtered depth itself
  Reversed,     // encoded of 1 − z
  OtherChannel  // another one of the same technique
};

struct StoredAssumption {
  StoredQuantity quantity = StoredQuantity::Own;
  int other = 0;  // the channel that OtherChannel means
  Kernel kernel;
  bool rowsFromBelow = false;
  double shiftX = 0.0, shiftY = 0.0;  // texels: what belongs to x lies at x + shiftX
  double scale = 1.0, offset = 0.0;   // stored = scale · exact + offset
};

// What is given: the map, the technique as it is adapted to it, the index of the channel, and the
// format whose last places are rounding.
struct StoredQuestion {
  const DepthMap& map;
  const Technique& technique;
  int channel = 0;
  Kernel kernel;
  StorageFormat format = StorageFormat::Float;
};

// How many things the assumption changes: quantity, kernel, order of rows, shift, scale.
int changesOf(const StoredAssumption& assumption, const Kernel& given);
// The changes as sentences: "The values are those of a box 5×5."
std::string sentencesOf(const StoredAssumption& assumption, const StoredQuestion& question);
// "own", "after-filter", "depth", "reversed" or "other-channel".
std::string_view nameOf(StoredQuantity quantity);

// What one channel would hold, texel by texel.
struct StoredExpectation {
  Image<double> values;  // in double
  // What differences are counted in: the last place of the question's format, at the mean of the
  // absolute values that are filtered, so that it is no smaller where terms cancel; or what one
  // rounding of the encoded depth to float changes, where that is more.
  Image<double> unit;
  // How far an engine that computes in float and stores in the question's format may be from
  // `values`: it stores before the filter and after each axis, by half a last place each; each
  // axis is an inner product of 2r + 1 terms, rounded by that many units of 2^-24 of its terms'
  // absolute sum at most (Higham 2002, section 3.1), and the encoding by two more; and the depth
  // that it encodes is rounded once.
  Image<double> allowance;
};
// One channel of `map`, which may be a part of the question's, before scale, shift and order of
// rows.
StoredExpectation expectedIn(const DepthMap& map, const StoredAssumption& assumption,
                             const StoredQuestion& question);
// The values alone.
Image<double> valuesIn(const DepthMap& map, const StoredAssumption& assumption,
                       const StoredQuestion& question);
// The whole channel.
StoredExpectation expectedUnder(const StoredAssumption& assumption, const StoredQuestion& question);

// Between texels as a texture unit reads; edge texels repeat.
double mixedAt(const Image<double>& image, double x, double y);
// The rows in the other order.
Image<double> turned(const Image<double>& image);
// The distance between neighbouring numbers of the format at `value`; of a normalised format the
// range that the channel stores over its largest whole number.
double lastPlaceOf(StorageFormat format, double value, const Channel& channel);

}  // namespace umbra
