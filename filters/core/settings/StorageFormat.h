// How a channel is stored per texel, and what a value becomes by being stored.
#pragma once

#include <string_view>

namespace umbra {

enum class StorageFormat { Unorm8, Unorm16, Half, Float, Double };

// `value` rounded to the nearest that the format holds. The normalised formats store the range
// [low, high] of the channel linearly and clamp to it.
double stored(double value, StorageFormat format, double low = 0.0, double high = 1.0);

// The largest finite magnitude; for the normalised formats that of the stored fraction, 1.
double largestOf(StorageFormat format);

// Half the distance between 1 and the next larger value: the relative rounding error of the
// floating formats, and the absolute one (of the stored fraction) of the normalised ones.
double unitRoundoff(StorageFormat format);

bool isNormalised(StorageFormat format);
// The bytes of one stored value.
int bytesOf(StorageFormat format);
std::string_view nameOf(StorageFormat format);

}  // namespace umbra
