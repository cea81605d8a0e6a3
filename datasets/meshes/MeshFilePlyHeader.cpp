#include "datasets/meshes/MeshFilePlyHeader.h"

#include <array>

#include "datasets/meshes/MeshFileText.h"

namespace umbra::meshfile {
namespace {

std::optional<PlyType> typeFrom(std::string_view name) {
  static const std::array<PlyType, 16> types{{{"char", 1, false, true},
                                              {"int8", 1, false, true},
                                              {"uchar", 1, false, false},
                                              {"uint8", 1, false, false},
                                              {"short", 2, false, true},
                                              {"int16", 2, false, true},
                                              {"ushort", 2, false, false},
                                              {"uint16", 2, false, false},
                                              {"int", 4, false, true},
                                              {"int32", 4, false, true},
                                              {"uint", 4, false, false},
                                              {"uint32", 4, false, false},
                                              {"float", 4, true, true},
                                              {"float32", 4, true, true},
                                              {"double", 8, true, true},
                                              {"float64", 8, true, true}}};
  for (const PlyType& type : types)
    if (type.name == name) return type;
  return std::nullopt;
}

std::optional<PlyFormat> formatFrom(std::string_view name) {
  if (name == "ascii") return PlyFormat::Ascii;
  if (name == "binary_little_endian") return PlyFormat::LittleEndian;
  if (name == "binary_big_endian") return PlyFormat::BigEndian;
  return std::nullopt;
}

std::optional<PlyElement> elementFrom(std::string_view line) {
  PlyElement element;
  element.name = nextWord(line);
  const std::optional<std::int64_t> count = wholeFrom(nextWord(line));
  if (!count || *count < 0 || *count > std::int64_t(UINT32_MAX)) return std::nullopt;
  element.count = std::uint64_t(*count);
  return element;
}

std::optional<PlyProperty> propertyFrom(std::string_view line) {
  PlyProperty property;
  std::string_view word = nextWord(line);
  if (word == "list") {
    property.count = typeFrom(nextWord(line));
    if (!property.count || property.count->real) return std::nullopt;
    word = nextWord(line);
  }
  const std::optional<PlyType> type = typeFrom(word);
  property.name = nextWord(line);
  if (!type || property.name.empty()) return std::nullopt;
  property.type = *type;
  return property;
}

}  // namespace

PlyHeader readPlyHeader(std::string_view& rest, const std::string& file) {
  PlyHeader header;
  std::optional<PlyFormat> format;
  if (nextLine(rest) != "ply") refuse(file, "is no PLY file; those begin with 'ply'");
  for (std::size_t number = 2;; ++number) {
    std::optional<std::string_view> line = nextLine(rest);
    if (!line) refuse(file, "ends before 'end_header'");
    const std::string whole(*line);
    const std::string_view key = nextWord(*line);
    bool right = true;
    if (key == "end_header") {
      break;
    } else if (key == "format") {
      right = (format = formatFrom(nextWord(*line))).has_value();
    } else if (key == "element") {
      const std::optional<PlyElement> element = elementFrom(*line);
      if ((right = element.has_value())) header.elements.push_back(*element);
    } else if (key == "property") {
      const std::optional<PlyProperty> property = propertyFrom(*line);
      right = property && !header.elements.empty();
      if (right) header.elements.back().properties.push_back(*property);
    } else {
      right = key == "comment" || key == "obj_info" || key.empty();
    }
    if (!right)
      refuseLine(file, number, "'" + whole.substr(0, 60) + "' is not right in a PLY header");
  }
  if (!format) refuse(file, "says no format; a PLY header has 'format ascii 1.0' or binary");
  header.format = *format;
  return header;
}

}  // namespace umbra::meshfile
