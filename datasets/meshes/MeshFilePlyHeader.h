// The header of a PLY file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbra::meshfile {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

struct PlyType {
  std::string name;
  int bytes = 0;
  bool real = false, isSigned = true;
};

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count;  // for a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<PlyElement> elements;
  // Lines that begin with no word of the format, and the first of them. Old exporters forgot to
  // write "comment".
  std::size_t unknownLines = 0;
  std::string firstUnknown;
};

// Removes the header from `rest` and returns it. Throws BadInput that names file and line.
PlyHeader readPlyHeader(std::string_view& rest, const std::string& file);

}  // namespace umbra::meshfile
