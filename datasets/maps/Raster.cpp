#include "datasets/maps/Raster.h"

#include <half.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace umbra {
namespace {

struct RasterFormat {
  const char* extension;
  RasterReader read;
};

constexpr std::array<RasterFormat, 3> rasterFormats{
    {{".exr", readExr}, {".pfm", readPfm}, {".npy", readNpy}}};

}  // namespace

double rounded(double value, RasterNumber number) {
  switch (number) {
    case RasterNumber::Half:
      return double(float(half(float(value))));
    case RasterNumber::Float:
      return double(float(value));
    case RasterNumber::Whole:
      return std::round(value);
    case RasterNumber::Double:
      break;
  }
  return value;
}

RasterReader rasterReaderOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  for (const RasterFormat& format : rasterFormats)
    if (extension == format.extension) return format.read;
  return nullptr;
}

std::string rasterExtensions() {
  std::string all;
  for (const RasterFormat& format : rasterFormats)
    (all += all.empty() ? "" : " ") += format.extension;
  return all;
}

}  // namespace umbra
