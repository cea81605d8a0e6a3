// The reference prefilter: channels of a whole map encoded, stored and reduced, in double.
#pragma once

#include <span>

#include "filters/core/maps/Image.h"
#include "filters/core/maps/Region.h"
#include "filters/core/settings/Kernel.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// Every texel through Technique::encode, rounded to `format`. As many channels as the technique. Of
// several samples of a texel the encodings' means, minima or maxima, as the channel is reduced.
Image<double> encodeMap(const DepthMap& map, const Technique& technique, StorageFormat format);

// Each channel reduced over the kernel's window, edge texels repeated. Means are weighted by the
// kernel; minima and maxima ignore its weights. The cost per texel does not grow with the radius
// for box, min and max (van Herk 1992; Gil & Werman 1993). The result is not rounded.
Image<double> reduceMap(const Image<double>& channels, std::span<const Channel> layout,
                        const Kernel& kernel);

// `channels` rounded to `format`, each within its own range.
void storeMap(Image<double>& channels, std::span<const Channel> layout, StorageFormat format);

// What the technique stores after the prefilter: encoded, stored, reduced, stored.
Image<double> prefilteredMap(const DepthMap& map, const Technique& technique, const Kernel& kernel,
                             StorageFormat format);

// The same for one texel only, straight from the taps of its region (regionAtTexel).
std::vector<double> prefilteredRegion(const Region& region, const Technique& technique,
                                      StorageFormat format);

// A bilinear read of the prefiltered map at (u, v) in [0,1] from the top-left corner: the four
// nearest stored texels mixed, minima and maxima as well, as a texture unit does it.
std::vector<double> readBilinear(const DepthMap& map, const Technique& technique,
                                 const Kernel& kernel, StorageFormat format, double u, double v);

// What any read of the technique's channels gives: averages as `regionOf` weighs them; minima and
// maxima of a mip level are those of its texels, and mixed like other values. Every mip level is
// rounded to `format` and made from the one below; what is mixed, or read from a table, is not
// rounded again. Throws BadCommandLine
// where the read cannot average the technique's channels (see Composition.h).
std::vector<double> readChannels(const DepthMap& map, const Technique& technique,
                                 const Kernel& kernel, StorageFormat format, const ReadPoint& read);

}  // namespace umbra
