// Depths in TIFF files of one value a pixel: floats of 16, 32 or 64 bits, or whole numbers of 8 or
// 16 bits, which are fractions of the largest one, as a window depth is. Strips or tiles, and every
// compression that libtiff reads.
#include <half.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>

#include "datasets/maps/Raster.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

// The most that libtiff may allocate at once: a row of tiles of the widest map has 64 MiB.
constexpr tmsize_t mostTiffBytes = tmsize_t(256) << 20;

// A file that is read through libtiff, whose messages stay here.
class TiffPicture {
 public:
  explicit TiffPicture(const fs::path& file) : file_(file) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(
        TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), mostTiffBytes);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &TiffPicture::hear, this);
    TIFFOpenOptionsSetWarningHandlerExtR(
        options.get(), [](TIFF*, void*, const char*, const char*, va_list) { return 1; }, nullptr);
    // "m": the file is read, not mapped, so that one that is cut meanwhile does no harm.
    tiff_.reset(TIFFOpenExt(file.c_str(), "rm", options.get()));
    if (!tiff_) refuse();
  }

  // A tag, or what the format says where it is absent.
  template <class Value>
  Value tag(std::uint32_t name) const {
    Value value{};
    TIFFGetFieldDefaulted(tiff_.get(), name, &value);
    return value;
  }
  TIFF* get() const { return tiff_.get(); }
  [[noreturn]] void refuse() const {
    refuseRaster(file_, "cannot be read as TIFF" +
                            (problem_.empty() ? "" : ": " + clipped(oneLine(problem_))));
  }

 private:
  static int hear(TIFF*, void* picture, const char*, const char* format, va_list arguments) {
    char text[80];
    std::vsnprintf(text, sizeof text, format, arguments);
    auto& problem = static_cast<TiffPicture*>(picture)->problem_;
    if (problem.empty()) problem = text;
    return 1;  // so that libtiff does not print it
  }

  const fs::path& file_;
  std::unique_ptr<TIFF, void (*)(TIFF*)> tiff_{nullptr, TIFFClose};
  std::string problem_;
};

struct TiffLayout {
  int width = 0, height = 0, bits = 0;
  bool isFloat = false;

  RasterNumber number() const {
    if (!isFloat) return bits == 8 ? RasterNumber::Fraction8 : RasterNumber::Fraction16;
    return bits == 16   ? RasterNumber::Half
           : bits == 32 ? RasterNumber::Float
                        : RasterNumber::Double;
  }
};

TiffLayout layoutOf(const fs::path& file, const TiffPicture& picture) {
  const auto width = picture.tag<std::uint32_t>(TIFFTAG_IMAGEWIDTH),
             height = picture.tag<std::uint32_t>(TIFFTAG_IMAGELENGTH);
  if (width < 1 || height < 1 || std::max(width, height) > std::uint32_t(largestRasterSide))
    refuseRaster(file,
                 "should have a width and a height from 1 to " + std::to_string(largestRasterSide));
  const int samples = picture.tag<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
  const int photometric = picture.tag<std::uint16_t>(TIFFTAG_PHOTOMETRIC);
  if (samples != 1 || photometric == PHOTOMETRIC_PALETTE)
    refuseRaster(file,
                 "is a colour picture, or has transparency; a depth map has one value a pixel");
  if (photometric == PHOTOMETRIC_MINISWHITE)
    refuseRaster(file, "counts its values from white; those of a depth map count from black");
  if (picture.tag<std::uint16_t>(TIFFTAG_ORIENTATION) != ORIENTATION_TOPLEFT)
    refuseRaster(file, "does not begin at its upper left; write it without a turn");
  const int kind = picture.tag<std::uint16_t>(TIFFTAG_SAMPLEFORMAT);
  const TiffLayout layout{int(width), int(height),
                          picture.tag<std::uint16_t>(TIFFTAG_BITSPERSAMPLE),
                          kind == SAMPLEFORMAT_IEEEFP};
  const bool isFraction = kind == SAMPLEFORMAT_UINT && (layout.bits == 8 || layout.bits == 16);
  const bool isFloat =
      layout.isFloat && (layout.bits == 16 || layout.bits == 32 || layout.bits == 64);
  if (!isFraction && !isFloat)
    refuseRaster(file,
                 "has values of " + std::to_string(layout.bits) +
                     " bits that are not read; floats of 16, 32 and 64 bits and whole numbers "
                     "without a sign of 8 and 16 bits are");
  const int compression = picture.tag<std::uint16_t>(TIFFTAG_COMPRESSION);
  if (compression == COMPRESSION_NONE || compression == COMPRESSION_LZW ||
      compression == COMPRESSION_ADOBE_DEFLATE || compression == COMPRESSION_DEFLATE ||
      compression == COMPRESSION_PACKBITS)
    checkRasterSize(file, layout.width, layout.height, layout.bits);
  return layout;
}

// libtiff gives values in the machine's own order of bytes.
double tiffValue(const unsigned char* bytes, const TiffLayout& layout) {
  const auto as = [bytes](auto value) {
    std::memcpy(&value, bytes, sizeof value);
    return value;
  };
  if (layout.bits == 8) return *bytes / 255.0;
  if (layout.bits == 64) return as(0.0);
  if (layout.bits == 32) return double(as(0.0f));
  const auto stored = as(std::uint16_t(0));
  if (!layout.isFloat) return stored / 65535.0;
  half value;
  value.setBits(stored);
  return double(float(value));
}

void readStrips(const TiffPicture& picture, const TiffLayout& layout, const RasterSink& sink) {
  const std::size_t valueBytes = std::size_t(layout.bits) / 8;
  const tmsize_t bytes = TIFFScanlineSize(picture.get());
  if (bytes != tmsize_t(valueBytes) * layout.width) picture.refuse();
  std::vector<unsigned char> stored(std::size_t(bytes), 0);
  std::vector<double> row(std::size_t(layout.width), 0.0);
  for (int y = 0; y < layout.height; ++y) {
    if (TIFFReadScanline(picture.get(), stored.data(), std::uint32_t(y)) != 1) picture.refuse();
    for (std::size_t x = 0; x < row.size(); ++x)
      row[x] = tiffValue(stored.data() + valueBytes * x, layout);
    sink.row(y, row);
  }
}

void readTiles(const fs::path& file, const TiffPicture& picture, const TiffLayout& layout,
               const RasterSink& sink) {
  const auto tileWidth = picture.tag<std::uint32_t>(TIFFTAG_TILEWIDTH),
             tileHeight = picture.tag<std::uint32_t>(TIFFTAG_TILELENGTH);
  if (tileWidth < 1 || tileHeight < 1 || std::max(tileWidth, tileHeight) > 4096)
    refuseRaster(file, "should have tiles of 1 to 4096 texels a side");
  const std::size_t valueBytes = std::size_t(layout.bits) / 8;
  const tmsize_t bytes = TIFFTileSize(picture.get());
  if (bytes != tmsize_t(valueBytes * tileWidth * tileHeight)) picture.refuse();
  const auto width = std::size_t(layout.width);
  const std::size_t across = (width + tileWidth - 1) / tileWidth;
  std::vector<unsigned char> stored(std::size_t(bytes), 0);
  std::vector<double> rows(across * tileWidth * tileHeight, 0.0);
  for (int top = 0; top < layout.height; top += int(tileHeight)) {
    for (std::size_t column = 0; column < across; ++column) {
      if (TIFFReadTile(picture.get(), stored.data(), std::uint32_t(column * tileWidth),
                       std::uint32_t(top), 0, 0) < 0)
        picture.refuse();
      for (std::size_t y = 0; y < tileHeight; ++y)
        for (std::size_t x = 0; x < tileWidth; ++x)
          rows[(y * across + column) * tileWidth + x] =
              tiffValue(stored.data() + valueBytes * (y * tileWidth + x), layout);
    }
    const int bottom = std::min(top + int(tileHeight), layout.height);
    for (int y = top; y < bottom; ++y)
      sink.row(y, std::span(rows).subspan(std::size_t(y - top) * across * tileWidth, width));
  }
}

}  // namespace

void readTiff(const fs::path& file, const std::string& channel, const RasterSink& sink) {
  if (!channel.empty()) refuseRaster(file, "a TIFF of one value a pixel has no named channels");
  checkInput(file);
  const TiffPicture picture(file);
  const TiffLayout layout = layoutOf(file, picture);
  const bool isAlone = TIFFLastDirectory(picture.get()) != 0;
  sink.begin({layout.width, layout.height, 0, 0, layout.number(),
              isAlone ? "" : "of several pictures in the file the first was read"});
  if (TIFFIsTiled(picture.get()))
    readTiles(file, picture, layout, sink);
  else
    readStrips(picture, layout, sink);
}

}  // namespace umbra
