#include "datasets/maps/RasterChannel.h"

#include <algorithm>

#include "filters/core/support/InputFile.h"

namespace umbra {

RasterChannel readRasterChannel(const std::filesystem::path& file, const std::string& channel) {
  checkInput(file);
  RasterChannel read;
  const RasterReader named = rasterReaderOf(file);
  (named ? named : readExr)(file, channel,
                            {[&](const RasterInfo& info) {
                               read.info = info;
                               read.values = Image<double>(info.width, info.height);
                             },
                             [&](int y, std::span<const double> row) {
                               std::copy(row.begin(), row.end(), &read.values(0, y));
                             }});
  return read;
}

}  // namespace umbra
