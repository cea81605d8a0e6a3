#include "datasets/maps/DepthFile.h"

#include <charconv>
#include <cmath>

#include "datasets/maps/DepthConversion.h"
#include "datasets/maps/Raster.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/support/Text.h"

namespace umbra {

namespace fs = std::filesystem;

namespace {

void checkRange(const fs::path& file, const DepthImport& import) {
  const std::string range =
      "the depth range from " + toText(import.atZero) + " to " + toText(import.atOne);
  if (!std::isfinite(import.atZero) || !std::isfinite(import.atOne) ||
      import.atZero == import.atOne)
    refuseRaster(file, range + " is empty; near and far must differ");
  if (!std::isfinite(import.atOne - import.atZero))
    refuseRaster(file, range + " is too wide to divide by");
}

}  // namespace

bool DepthMiss::operator==(const DepthMiss& other) const {
  return kind == other.kind &&
         (value == other.value || (std::isnan(value) && std::isnan(other.value)));
}

DepthMiss depthMissFrom(std::string_view text, std::string_view where) {
  if (text == "error") return {};
  if (text == "clamp") return {DepthMiss::Kind::Clamp, 0.0};
  DepthMiss miss{DepthMiss::Kind::Value, 0.0};
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), miss.value);
  if (problem != std::errc() || end != text.data() + text.size())
    throw Error(ErrorKind::BadInput, std::string(where) + ": '" + clipped(text) +
                                         "' is not right, it takes error, clamp or a number such "
                                         "as 1e10, inf or nan");
  return miss;
}

std::string toText(const DepthMiss& miss) {
  if (miss.kind == DepthMiss::Kind::Error) return "error";
  if (miss.kind == DepthMiss::Kind::Clamp) return "clamp";
  return toText(ParameterValue(miss.value));
}

DepthFile readDepth(const fs::path& file, const DepthImport& import) {
  checkRange(file, import);
  checkInput(file);
  const RasterReader read = rasterReaderOf(file);
  DepthConversion conversion(import, file.string());
  if (!read && file.has_extension())
    refuseRaster(file, "is no depth map; those end in " + rasterExtensions());
  // A file without an extension is one of OpenEXR, or refused as such.
  (read ? read : readExr)(file, import.channel,
                          {[&](const RasterInfo& info) { conversion.begin(info); },
                           [&](int y, std::span<const double> row) { conversion.add(y, row); }});
  return conversion.finish();
}

DepthMap readDepthFile(const fs::path& file, const std::string& channel, double atZero,
                       double atOne) {
  return readDepth(file, {channel, atZero, atOne, {}, {}}).map;
}

std::pair<fs::path, std::string> splitDepthArgument(const std::string& argument) {
  const std::size_t colon = argument.rfind(':');
  if (colon == std::string::npos || colon < 4) return {argument, ""};
  std::string extension = argument.substr(colon - 4, 4);
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".exr") return {argument, ""};
  return {argument.substr(0, colon), argument.substr(colon + 1)};
}

}  // namespace umbra
