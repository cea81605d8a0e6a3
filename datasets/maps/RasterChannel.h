// One channel of a file as it stands there, whatever it means.
#pragma once

#include <filesystem>
#include <string>

#include "datasets/maps/Raster.h"
#include "filters/core/maps/Image.h"

namespace umbra {

struct RasterChannel {
  Image<double> values;
  RasterInfo info;
};

// Throws BadInput that begins with the file's name.
RasterChannel readRasterChannel(const std::filesystem::path& file, const std::string& channel);

}  // namespace umbra
