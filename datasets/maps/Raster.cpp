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

constexpr std::array<RasterFormat, 6> rasterFormats{{{".exr", readExr},
                                                     {".pfm", readPfm},
                                                     {".npy", readNpy},
                                                     {".png", readPng},
                                                     {".tif", readTiff},
                                                     {".tiff", readTiff}}};

// The largest whole number that stands for 1; 0 where values are no fractions.
double fractionOf(RasterNumber number) {
  return number == RasterNumber::Fraction8    ? 255.0
         : number == RasterNumber::Fraction16 ? 65535.0
                                              : 0.0;
}

}  // namespace

std::string_view nameOf(RasterNumber number) {
  switch (number) {
    case RasterNumber::Half:
      return "half";
    case RasterNumber::Float:
      return "float";
    case RasterNumber::Double:
      return "double";
    case RasterNumber::Fraction8:
      return "fractions of 255";
    case RasterNumber::Fraction16:
      return "fractions of 65535";
    case RasterNumber::Whole:
      break;
  }
  return "whole numbers";
}

void refuseRaster(const std::filesystem::path& file, const std::string& what) {
  throw Error(ErrorKind::BadInput, file.string() + ": " + what);
}

void checkRasterSize(const std::filesystem::path& file, std::int64_t width, std::int64_t height,
                     int bits) {
  const auto bytes = std::int64_t(std::filesystem::file_size(file));
  if (width * height * bits > 8 * 1100 * bytes)
    refuseRaster(file, "promises " + std::to_string(width) + " × " + std::to_string(height) +
                           " pixels, which its " + std::to_string(bytes) + " bytes cannot hold");
}

double rounded(double value, RasterNumber number) {
  switch (number) {
    case RasterNumber::Half:
      return double(float(half(float(value))));
    case RasterNumber::Float:
      return double(float(value));
    case RasterNumber::Whole:
      return std::round(value);
    case RasterNumber::Fraction8:
    case RasterNumber::Fraction16:
      return std::round(value * fractionOf(number)) / fractionOf(number);
    case RasterNumber::Double:
      break;
  }
  return value;
}

std::string shortest(double value, RasterNumber number) {
  char buffer[32];
  if (fractionOf(number) > 0.0) {
    for (int digits = 1;; ++digits) {
      const auto end =
          std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits)
              .ptr;
      double read = 0.0;
      std::from_chars(buffer, end, read);
      // A value that the file does not hold itself takes all the digits that it has.
      if (digits == 17 || (rounded(value, number) == value ? rounded(read, number) : read) == value)
        return {buffer, end};
    }
  }
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
