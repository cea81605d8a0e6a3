#include "datasets/meshes/MeshFilePlyHeader.h"

#include <algorithm>
#include <array>

#include "datasets/meshes/MeshFileText.h"
#include "filters/core/support/Text.h"

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
    if (!property.count) return std::nullopt;
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
  TextLines lines(rest);
  std::optional<std::string_view> line = lines.next();
  if (!line || lowered(trimmed(*line)) != "ply")
    refuse(file, "is no PLY file; those begin with 'ply'");
  const bool endsInCrLf = rest.substr(std::size_t(line->end() - rest.begin())).starts_with("\r\n");
  while (true) {
    line = lines.next();
    if (!line) refuse(file, "ends before 'end_header'");
    std::string_view words = *line;
    const std::string_view key = nextWord(words);
    bool right = true;
    if (key == "end_header") {
      break;
    } else if (key == "format") {
      right = (format = formatFrom(nextWord(words))).has_value();
    } else if (key == "element") {
      const std::optional<PlyElement> element = elementFrom(words);
      if ((right = element.has_value())) header.elements.push_back(*element);
    } else if (key == "property") {
      const std::optional<PlyProperty> property = propertyFrom(words);
      right = property && !header.elements.empty();
      if (right) header.elements.back().properties.push_back(*property);
    } else if (key != "comment" && key != "obj_info" && !key.empty()) {
      if (header.unknownLines++ == 0) header.firstUnknown = clipped(*line);
    }
    if (!right)
      refuseLine(file, lines.number(), "'" + clipped(*line) + "' is not right in a PLY header");
  }
  // A program that writes CR and LF for each LF did so to the values, too.
  const std::size_t firstEnd = rest.find('\r');
  if (format && *format != PlyFormat::Ascii &&
      rest.substr(std::min(firstEnd, rest.size())).starts_with("\r\r\n"))
    refuse(file, "was written as text although it is binary: its lines end in CR, CR and LF");
  if (!format) refuse(file, "says no format; a PLY header has 'format ascii 1.0' or binary");
  header.format = *format;
  // Bytes follow the header at once. One that is a line feed belongs to it only if its lines end in
  // CR and LF.
  std::size_t end = std::size_t(line->end() - rest.begin()) + 1;
  if (endsInCrLf && rest.substr(end - 1).starts_with("\r\n")) ++end;
  rest.remove_prefix(std::min(end, rest.size()));
  return header;
}

}  // namespace umbra::meshfile
