// The reference prefilter: it encodes, stores and reduces the channels of a whole map, in double.
#pragma once

#include <span>

#include "filters/core/maps/Image.h"
#include "filters/core/maps/Region.h"
#include "filters/core/settings/Kernel.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// Encodes every texel by Technique::encode and rounds to `format`. The result has the technique's
// channels. Where a texel has several samples, their encodings are reduced to a mean, minimum or
// maximum, as the channel is.
Image<double> encodeMap(const DepthMap& map, const Technique& technique, StorageFormat format);

// Reduces each channel over the kernel's window; edge texels repeat. Means are weighted by the
// kernel; minima and maxima ignore its weights. For box, minimum and maximum the cost per texel
// does not grow with the radius (van Herk 1992; Gil & Werman 1993). The result is not rounded.
Image<double> reduceMap(const Image<double>& channels, std::span<const Channel> layout,
                        const Kernel& kernel);

// Rounds `channels` to `format`, each within its own range.
void storeMap(Image<double>& channels, std::span<const Channel> layout, StorageFormat format);

// What the technique stores after the prefilter: its channels are encoded, stored, reduced and
// stored again.
Image<double> prefilteredMap(const DepthMap& map, const Technique& technique, const Kernel& kernel,
                             StorageFormat format);

// Some rows of the same, to the last bit, where `first` is a multiple of the kernel's window,
// 2r + 1: the work and the memory are those of these rows and r more on either side.
struct Rows {
  int first = 0, count = 0;
};
Image<double> prefilteredRows(const DepthMap& map, const Technique& technique, const Kernel& kernel,
                              StorageFormat format, const Rows& rows);
// What `reduceMap` gives in these rows of an image of which only some are known: `known` is in
// `channels` from its top, and holds those that the kernel reaches.
Image<double> reducedRows(const Image<double>& channels, std::span<const Channel> layout,
                          const Kernel& kernel, const Rows& known, const Rows& rows);
// The rows of a map of `height` rows that the kernel reaches from `rows`.
Rows reachedRows(const Kernel& kernel, const Rows& rows, int height);

// The same for one texel only, computed straight from the taps of its region (regionAtTexel).
std::vector<double> prefilteredRegion(const Region& region, const Technique& technique,
                                      StorageFormat format);

// A bilinear read of the prefiltered map at (u, v) in [0,1] from the top-left corner. It mixes the
// four nearest stored texels, minima and maxima included, as a texture unit does.
std::vector<double> readBilinear(const DepthMap& map, const Technique& technique,
                                 const Kernel& kernel, StorageFormat format, double u, double v);

// The channels that any read gives. Averages are weighted as in `regionOf`. Minima and maxima of a
// mip level are those of its texels, and are mixed like other values. Every mip level is rounded to
// `format` and made from the one below; what is mixed, or read from a table, is not rounded again.
// Throws BadCommandLine where the read cannot average the technique's channels (see Composition.h).
std::vector<double> readChannels(const DepthMap& map, const Technique& technique,
                                 const Kernel& kernel, StorageFormat format, const ReadPoint& read);

}  // namespace umbra
