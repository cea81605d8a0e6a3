// Depth maps in OpenEXR files.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "filters/core/maps/Image.h"

namespace umbra {

// Reads the channel `channel` of `file` ("" is Z, or else the only channel) and maps its values
// from [near, far] to [0, 1], in double. The file may have half or float pixels, tiles or scan
// lines, and several parts, whose channels are named "part.channel"; deep files are refused. Throws
// BadInput that names the file and what is wrong: the channels that there are, or the texel of a
// value that is not finite or outside the range.
DepthMap readDepthFile(const std::filesystem::path& file, const std::string& channel = "",
                       double near = 0.0, double far = 1.0);

// `path:CHANNEL` split at the last colon that follows ".exr"; the channel may be absent.
std::pair<std::filesystem::path, std::string> splitDepthArgument(const std::string& argument);

}  // namespace umbra
