#include "datasets/maps/Raster.h"

#include <half.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

struct RasterFormat {
  const char* extension;
  RasterReader read;
};

constexpr std::array<RasterFormat, 3> rasterFormats{
    {{".exr", readExr}, {".pfm", readPfm}, {".npy", readNpy}}};

}  // namespace

std::string_view nameOf(RasterNumber number) {
  switch (number) {
    case RasterNumber::Half:
      return "half";
    case RasterNumber::Float:
      return "float";
    case RasterNumber::Double:
      return "double";
    case RasterNumber::Whole:
      break;
  }
  return "whole numbers";
}

void refuseRaster(const std::filesystem::path& file, const std::string& what) {
  throw Error(ErrorKind::BadInput, file.string() + ": " + what);
}

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

std::string shortest(double value, RasterNumber number) {
  char buffer[32];
  const bool isWide = number == RasterNumber::Double || number == RasterNumber::Whole;
  const auto end = isWide ? std::to_chars(buffer, buffer + sizeof buffer, value).ptr
                          : std::to_chars(buffer, buffer + sizeof buffer, float(value)).ptr;
  return {buffer, end};
}

RasterReader rasterReaderOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  for (const RasterFormat& format : rasterFormats)
    if (extension == format.extension) return format.read;
  return nullptr;
}

std::vector<std::string> rasterChannels(const std::filesystem::path& file) {
  const RasterReader read = rasterReaderOf(file);
  if (read && read != readExr) return {};
  return exrChannels(file);
}

std::string rasterExtensions() {
  std::string all;
  for (const RasterFormat& format : rasterFormats)
    (all += all.empty() ? "" : " ") += format.extension;
  return all;
}

}  // namespace umbra
