// Depth files that tests write, byte by byte or through the library of their format.
#pragma once

#include <png.h>
#include <tiffio.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace umbra {

inline void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

inline std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::string floatBytes(const std::vector<float>& values, bool bigEnd = false) {
  std::string out;
  for (float value : values) {
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &value, 4);
    if (bigEnd) std::reverse(bytes.begin(), bytes.end());
    out += bytes;
  }
  return out;
}

// A NumPy array with these entries in its header.
inline std::string npy(const std::string& type, const std::string& order, const std::string& shape,
                       const std::string& values) {
  std::string head =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  head.resize((head.size() + 10 + 64) / 64 * 64 - 11, ' ');
  head += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + char(head.size() & 0xff) + char(head.size() >> 8) +
         head + values;
}

// A picture as libpng writes it; `bits` of each value that `colour` asks for, rows of big-endian
// values.
inline void writePng(const std::filesystem::path& file, int width, int height, int bits,
                     const std::vector<unsigned char>& rows, int colour = PNG_COLOR_TYPE_GRAY,
                     int interlace = PNG_INTERLACE_NONE) {
  const std::unique_ptr<FILE, int (*)(FILE*)> stream(std::fopen(file.c_str(), "wb"), std::fclose);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, stream.get());
  png_set_IHDR(png, info, png_uint_32(width), png_uint_32(height), bits, colour, interlace,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  std::vector<unsigned char> copy = rows;
  std::vector<png_bytep> starts;
  for (int y = 0; y < height; ++y)
    starts.push_back(copy.data() + rows.size() / std::size_t(height) * std::size_t(y));
  png_write_image(png, starts.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
}

struct TiffSample {
  int width = 3, height = 2, bits = 32;
  int kind = SAMPLEFORMAT_IEEEFP, compression = COMPRESSION_NONE, samples = 1;
  int photometric = PHOTOMETRIC_MINISBLACK, orientation = ORIENTATION_TOPLEFT;
  int tile = 0;       // texels a side; 0: strips
  int predictor = 1;  // 3: of floats
  int pictures = 1;   // all the same
};

// A file as libtiff writes it; rows of values in the machine's order of bytes.
inline void writeTiff(const std::filesystem::path& file, const TiffSample& sample,
                      const void* rows) {
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(file.c_str(), "w"), TIFFClose);
  const std::size_t valueBytes = std::size_t(sample.bits / 8 * sample.samples);
  const std::size_t rowBytes = valueBytes * std::size_t(sample.width);
  const auto* bytes = static_cast<const unsigned char*>(rows);
  for (int picture = 0; picture < sample.pictures; ++picture) {
    TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, sample.width);
    TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, sample.height);
    TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, sample.bits);
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLEFORMAT, sample.kind);
    TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, sample.samples);
    TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, sample.photometric);
    TIFFSetField(tiff.get(), TIFFTAG_ORIENTATION, sample.orientation);
    TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, sample.compression);
    if (sample.predictor != 1) TIFFSetField(tiff.get(), TIFFTAG_PREDICTOR, sample.predictor);
    if (sample.tile > 0) {
      const auto side = std::size_t(sample.tile);
      TIFFSetField(tiff.get(), TIFFTAG_TILEWIDTH, sample.tile);
      TIFFSetField(tiff.get(), TIFFTAG_TILELENGTH, sample.tile);
      for (int top = 0; top < sample.height; top += sample.tile)
        for (int left = 0; left < sample.width; left += sample.tile) {
          std::vector<unsigned char> tile(side * side * valueBytes, 0);
          const auto columns = std::size_t(std::min(sample.tile, sample.width - left));
          for (int y = top; y < std::min(top + sample.tile, sample.height); ++y)
            std::memcpy(tile.data() + std::size_t(y - top) * side * valueBytes,
                        bytes + std::size_t(y) * rowBytes + std::size_t(left) * valueBytes,
                        columns * valueBytes);
          TIFFWriteTile(tiff.get(), tile.data(), std::uint32_t(left), std::uint32_t(top), 0, 0);
        }
    } else {
      TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, 1);
      for (int y = 0; y < sample.height; ++y) {
        // libtiff turns the bytes of what it is given where the file asks for that.
        std::vector<unsigned char> row(bytes + std::size_t(y) * rowBytes,
                                       bytes + std::size_t(y + 1) * rowBytes);
        TIFFWriteScanline(tiff.get(), row.data(), std::uint32_t(y), 0);
      }
    }
    TIFFWriteDirectory(tiff.get());
  }
}

}  // namespace umbra
