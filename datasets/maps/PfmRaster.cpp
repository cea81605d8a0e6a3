// Depths in portable float maps: "Pf", width, height and a scale whose sign is the byte order, then
// floats from the bottom row upwards. The format is too small for a library.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "datasets/maps/Raster.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

// Removes the next word and the one blank that ends it.
std::string_view pfmWord(std::string_view& rest) {
  const std::size_t start = rest.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return {};
  rest.remove_prefix(start);
  const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
  rest.remove_prefix(std::min(rest.size(), word.size() + 1));
  return word;
}

int sideFrom(std::string_view word) {
  int side = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), side);
  const bool right = problem == std::errc() && end == word.data() + word.size() && side > 0 &&
                     side <= largestRasterSide;
  return right ? side : 0;
}

float pfmFloat(const char* bytes, bool bigEnd) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i)
    bits |= std::uint32_t(static_cast<unsigned char>(bytes[i])) << (8 * (bigEnd ? 3 - i : i));
  return std::bit_cast<float>(bits);
}

}  // namespace

void readPfm(const fs::path& file, const std::string& channel, const RasterSink& sink) {
  if (!channel.empty()) refuseRaster(file, "a portable float map has no named channels");
  const std::string content = contentOf(file, std::uintmax_t(5) << 30);
  std::string_view rest = content;
  const std::string_view kind = pfmWord(rest);
  if (kind == "PF") refuseRaster(file, "is a colour picture (PF); a depth map has one value (Pf)");
  if (kind != "Pf") refuseRaster(file, "is no portable float map; those begin with 'Pf'");
  const int width = sideFrom(pfmWord(rest)), height = sideFrom(pfmWord(rest));
  if (width == 0 || height == 0)
    refuseRaster(file,
                 "should say a width and a height from 1 to " + std::to_string(largestRasterSide));
  const std::string_view scaleWord = pfmWord(rest);
  double scale = 0.0;
  const auto [end, problem] =
      std::from_chars(scaleWord.data(), scaleWord.data() + scaleWord.size(), scale);
  if (problem != std::errc() || end != scaleWord.data() + scaleWord.size() || scale == 0.0 ||
      !std::isfinite(scale))
    refuseRaster(file, "should say a scale that is not 0, below 0 for little-endian floats");
  // The one blank after the scale was removed; where lines end in CR and LF, half of it.
  if (rest.data()[-1] == '\r' && rest.starts_with('\n')) rest.remove_prefix(1);
  const std::size_t bytes = 4 * std::size_t(width) * std::size_t(height);
  if (rest.size() < bytes)
    refuseRaster(file, "is truncated: it promises " + std::to_string(bytes) +
                           " bytes of values and has " + std::to_string(rest.size()));
  if (rest.size() > bytes)
    refuseRaster(file,
                 "has " + std::to_string(rest.size() - bytes) +
                     " bytes more than its values take, so that where these begin is in doubt");
  sink.begin({width, height, 0, 0, RasterNumber::Float});
  std::vector<double> row(std::size_t(width), 0.0);
  for (int y = 0; y < height; ++y) {
    const char* start = rest.data() + 4 * std::size_t(width) * std::size_t(height - 1 - y);
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = pfmFloat(start + 4 * x, scale > 0.0);
    sink.row(y, row);
  }
}

}  // namespace umbra
