// The check of a PLY file. It walks over the elements as the header lays them out, and copies what
// the picture needs.
#include <algorithm>
#include <array>

#include "datasets/meshes/MeshFileCheck.h"
#include "datasets/meshes/MeshFilePlyHeader.h"
#include "datasets/meshes/MeshFileText.h"

namespace umbra {
namespace {

using namespace meshfile;

constexpr std::array<std::string_view, 6> vertexProperties{"x", "y", "z", "nx", "ny", "nz"};

bool isFaceList(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool has(const PlyElement& element, std::string_view name) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const PlyProperty& p) { return !p.count && p.name == name; });
}

class PlyCheck {
 public:
  PlyCheck(std::string_view content, const std::string& name) : rest_(content), name_(name) {}

  CheckedMesh run() {
    header_ = readPlyHeader(rest_, name_);
    findElements();
    writeHeader();
    for (const PlyElement& element : header_.elements) {
      read_ = 0;
      if (element.properties.empty()) continue;  // whatever its count, it takes no bytes
      for (element_ = &element; read_ < element.count; ++read_) copyElement();
      // The elements after this one are not needed, and often are of unusual kinds.
      if (&element == face_) break;
    }
    return std::move(mesh_);
  }

 private:
  void findElements() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex" && !vertex_) vertex_ = &element;
      if (element.name == "face" && !face_) face_ = &element;
    }
    if (!vertex_ || !face_ || face_ < vertex_)
      refuse(name_, "has no element 'vertex' followed by an element 'face'");
    if (!has(*vertex_, "x") || !has(*vertex_, "y") || !has(*vertex_, "z"))
      refuse(name_, "has vertices without x, y and z");
    normals_ = has(*vertex_, "nx") && has(*vertex_, "ny") && has(*vertex_, "nz");
    if (std::count_if(face_->properties.begin(), face_->properties.end(), isFaceList) != 1)
      refuse(name_, "has faces without one list 'vertex_indices'");
    for (std::string_view name : vertexProperties)
      if (std::count_if(vertex_->properties.begin(), vertex_->properties.end(),
                        [&](const PlyProperty& p) { return p.name == name; }) > 1)
        refuse(name_, "names the vertex property '" + std::string(name) + "' twice");
    mesh_.vertices = vertex_->count;
    mesh_.faces = face_->count;
    mesh_.binary = header_.format != PlyFormat::Ascii;
  }

  bool keeps(const PlyProperty& property) const {
    if (element_ == face_) return isFaceList(property);
    if (element_ != vertex_ || property.count) return false;
    const auto found = std::find(vertexProperties.begin(), vertexProperties.end(), property.name);
    return found < vertexProperties.begin() + (normals_ ? 6 : 3);
  }

  void writeHeader() {
    constexpr std::array<std::string_view, 3> formats{"ascii", "binary_little_endian",
                                                      "binary_big_endian"};
    std::string& out = mesh_.content;
    ((out += "ply\nformat ") += formats[std::size_t(header_.format)]) += " 1.0\n";
    for (const PlyElement* element : {vertex_, face_}) {
      element_ = element;
      out += "element " + element->name + " " + std::to_string(element->count) + "\n";
      for (const PlyProperty& property : element->properties)
        if (keeps(property))
          out += "property " + (property.count ? "list " + property.count->name + " " : "") +
                 property.type.name + " " + (property.count ? "vertex_indices" : property.name) +
                 "\n";
    }
    out += "end_header\n";
  }

  [[noreturn]] void truncated() const {
    refuse(name_, "is truncated: it promises " + std::to_string(vertex_->count) + " vertices and " +
                      std::to_string(face_->count) + " faces, but ends after " +
                      std::to_string(read_) + " of " + std::to_string(element_->count) + " '" +
                      element_->name + "'");
  }

  [[noreturn]] void wrong(const std::string& what, std::string_view found) const {
    refuse(name_, "has a " + element_->name + " (number " + std::to_string(read_) + ") whose " +
                      what + " is '" + std::string(found.substr(0, 40)) + "'");
  }

  void copyElement() {
    bool finite = true;
    const bool text = !mesh_.binary;
    for (const PlyProperty& property : element_->properties) {
      std::uint64_t length = 1;
      if (property.count) length = copyLength(property);
      text ? copyWords(property, length, finite)
           : copyBytes(length * property.type.bytes, property);
    }
    if (text && (element_ == vertex_ || element_ == face_)) mesh_.content += '\n';
    if (element_ == vertex_ && !finite) mesh_.nonFinite.push_back(std::uint32_t(read_));
  }

  std::uint64_t copyLength(const PlyProperty& property) {
    std::int64_t length = 0;
    if (mesh_.binary) {
      length = binaryLength(*property.count);
      copyBytes(std::uint64_t(property.count->bytes), property);
    } else {
      const std::string_view word = nextWord(rest_);
      if (word.empty()) truncated();
      length = wholeFrom(word).value_or(-1);
      if (length < 0) wrong("list length", word);
      if (keeps(property)) (mesh_.content += ' ') += word;
    }
    if (length < 0) wrong("list length", std::to_string(length));
    if (std::uint64_t(length) > rest_.size()) truncated();  // a byte an entry at least
    if (element_ == face_ && isFaceList(property) && length < 3)
      wrong("number of vertices", std::to_string(length));
    return std::uint64_t(length);
  }

  std::int64_t binaryLength(const PlyType& type) const {
    if (rest_.size() < std::size_t(type.bytes)) truncated();
    std::uint64_t value = 0;
    for (int i = 0; i < type.bytes; ++i) {
      const int shift = header_.format == PlyFormat::BigEndian ? type.bytes - 1 - i : i;
      value |= std::uint64_t(static_cast<unsigned char>(rest_[std::size_t(i)])) << (8 * shift);
    }
    const std::uint64_t sign = std::uint64_t(1) << (8 * type.bytes - 1);
    return type.isSigned && (value & sign) ? -1 : std::int64_t(value);
  }

  void copyBytes(std::uint64_t bytes, const PlyProperty& property) {
    if (rest_.size() < bytes) truncated();
    if (keeps(property)) mesh_.content += rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
  }

  void copyWords(const PlyProperty& property, std::uint64_t count, bool& finite) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string_view word = nextWord(rest_);
      if (word.empty()) truncated();
      if (!keeps(property)) continue;
      if (property.count) {
        if (!wholeFrom(word)) wrong("vertex", word);
        (mesh_.content += ' ') += word;
        continue;
      }
      const std::optional<float> value = realFrom(word);
      if (!value) wrong(property.name, word);
      const bool isFinite = *value - *value == 0.0f;
      // A normal that is not a number counts as none; the vertex stays.
      if (!isFinite && property.name.size() == 1) finite = false;
      (mesh_.content += ' ') += isFinite && *value != 0.0f ? word : std::string_view("0");
    }
  }

  std::string_view rest_;
  const std::string& name_;
  PlyHeader header_;
  const PlyElement *vertex_ = nullptr, *face_ = nullptr, *element_ = nullptr;
  std::uint64_t read_ = 0;  // elements of the kind `element_` so far
  bool normals_ = false;
  CheckedMesh mesh_;
};

}  // namespace

CheckedMesh checkPly(const std::string& content, const std::string& name) {
  return PlyCheck(content, name).run();
}

}  // namespace umbra
