// Depth maps and channels in OpenEXR files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "filters/core/maps/Image.h"

namespace umbra {

// Reads the channel `channel` of `file` ("" is Z, or else the only channel) and maps its values
// from [near, far] to [0, 1], in double. The file may have half or float pixels, tiles or scan
// lines, and several parts, whose channels are named "part.channel"; deep files are refused. Throws
// BadInput that names the file and what is wrong: the channels that there are, or the texel of a
// value that is not finite or outside the range.
DepthMap readDepthFile(const std::filesystem::path& file, const std::string& channel = "",
                       double near = 0.0, double far = 1.0);

// Splits `path:CHANNEL` at the last colon that follows ".exr"; the channel may be absent.
std::pair<std::filesystem::path, std::string> splitDepthArgument(const std::string& argument);

enum class ExrPixel { Half, Float };

// Writes one part with one channel for each image, ZIP-compressed. `attributes` become string
// attributes. Throws BadOutput and then leaves no file half written.
void writeExr(const std::filesystem::path& file,
              const std::map<std::string, Image<float>>& channels,
              const std::map<std::string, std::string>& attributes,
              ExrPixel pixel = ExrPixel::Float);

}  // namespace umbra
