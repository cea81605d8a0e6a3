// Depths in NumPy's .npy files, versions 1 to 3: an array of two dimensions, rows then columns, of
// floats of 2, 4 or 8 bytes or whole numbers. Debian packages no small library that reads them.
#include <half.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <optional>

#include "datasets/maps/Raster.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

struct NpyHeader {
  char kind = 0;  // 'f', 'i' or 'u'
  int bytes = 0;
  bool bigEnd = false, columnsFirst = false;
  int width = 0, height = 0;
};

// What follows "'key':" in the header, which is a dictionary as Python writes it.
std::string_view entryOf(std::string_view header, std::string_view key) {
  const std::size_t at = header.find("'" + std::string(key) + "'");
  if (at == std::string_view::npos) return {};
  const std::size_t colon = header.find(':', at);
  if (colon == std::string_view::npos) return {};
  const std::size_t start = header.find_first_not_of(' ', colon + 1);
  return start == std::string_view::npos ? std::string_view() : header.substr(start);
}

// The whole numbers of "(4, 6)".
std::vector<int> shapeFrom(std::string_view text) {
  std::vector<int> sides;
  for (text = text.substr(0, text.find(')')); !text.empty();) {
    const std::size_t digit = text.find_first_of("0123456789");
    if (digit == std::string_view::npos) break;
    text.remove_prefix(digit);
    int side = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), side);
    sides.push_back(problem == std::errc() ? side : 0);
    text.remove_prefix(std::size_t(end - text.data()));
  }
  return sides;
}

NpyHeader npyHeader(const fs::path& file, std::string_view text) {
  NpyHeader header;
  const std::string_view type = entryOf(text, "descr");
  if (type.size() < 4 || type[0] != '\'')
    refuseRaster(file, "holds an array of records; a depth map is one array of numbers");
  header.bigEnd = type[1] == '>';
  header.kind = type[2];
  header.bytes = type[3] - '0';
  const bool isFloat =
      header.kind == 'f' && (header.bytes == 2 || header.bytes == 4 || header.bytes == 8);
  const bool isWhole = (header.kind == 'i' || header.kind == 'u') &&
                       (header.bytes == 1 || header.bytes == 2 || header.bytes == 4);
  if (!isFloat && !isWhole)
    refuseRaster(file, "holds numbers of the type " + clipped(type.substr(0, type.find(','))) +
                           "; float16, float32, float64 and whole numbers up to 32 bits are read");
  header.columnsFirst = entryOf(text, "fortran_order").starts_with("True");
  const std::vector<int> shape = shapeFrom(entryOf(text, "shape"));
  const bool isMap = shape.size() == 2 || (shape.size() == 3 && shape[2] == 1);
  if (!isMap || shape[0] < 1 || shape[1] < 1 || std::max(shape[0], shape[1]) > largestRasterSide)
    refuseRaster(file,
                 "has not the shape of a depth map: two dimensions, rows and columns, from 1 to " +
                     std::to_string(largestRasterSide));
  header.height = shape[0];
  header.width = shape[1];
  return header;
}

double npyValue(const char* bytes, const NpyHeader& header) {
  std::uint64_t bits = 0;
  for (int i = 0; i < header.bytes; ++i)
    bits |= std::uint64_t(static_cast<unsigned char>(bytes[i]))
            << (8 * (header.bigEnd ? header.bytes - 1 - i : i));
  if (header.kind == 'u') return double(bits);
  if (header.kind == 'i') {
    const int unused = 64 - 8 * header.bytes;  // fills up with the sign
    return double(std::int64_t(bits << unused) >> unused);
  }
  if (header.bytes == 8) return std::bit_cast<double>(bits);
  if (header.bytes == 4) return std::bit_cast<float>(std::uint32_t(bits));
  half value;
  value.setBits(std::uint16_t(bits));
  return double(float(value));
}

RasterNumber npyNumber(const NpyHeader& header) {
  if (header.kind != 'f') return RasterNumber::Whole;
  return header.bytes == 2   ? RasterNumber::Half
         : header.bytes == 4 ? RasterNumber::Float
                             : RasterNumber::Double;
}

}  // namespace

void readNpy(const fs::path& file, const std::string& channel, const RasterSink& sink) {
  if (!channel.empty()) refuseRaster(file, "a NumPy array has no named channels");
  const std::string content = contentOf(file, std::uintmax_t(5) << 30);
  const auto byteAt = [&](std::size_t i) {
    return std::size_t(static_cast<unsigned char>(content[i]));
  };
  if (content.size() < 12 || !content.starts_with("\x93NUMPY"))
    refuseRaster(file, "is no NumPy array; those begin with '\\x93NUMPY'");
  const bool isLong = byteAt(6) >= 2;
  const std::size_t start = isLong ? 12 : 10;
  const std::size_t length = isLong
                                 ? byteAt(8) | byteAt(9) << 8 | byteAt(10) << 16 | byteAt(11) << 24
                                 : byteAt(8) | byteAt(9) << 8;
  if (length > content.size() - start)
    refuseRaster(file, "is truncated: it ends within its header");
  const NpyHeader header = npyHeader(file, std::string_view(content).substr(start, length));
  const std::size_t width = std::size_t(header.width), height = std::size_t(header.height),
                    bytes = std::size_t(header.bytes);
  const std::string_view values = std::string_view(content).substr(start + length);
  if (values.size() < width * height * bytes)
    refuseRaster(file, "is truncated: it promises " + std::to_string(width * height * bytes) +
                           " bytes of values and has " + std::to_string(values.size()));
  sink.begin({header.width, header.height, 0, 0, npyNumber(header)});
  std::vector<double> row(width, 0.0);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x)
      row[x] = npyValue(
          values.data() + bytes * (header.columnsFirst ? x * height + y : y * width + x), header);
    sink.row(int(y), row);
  }
}

}  // namespace umbra
