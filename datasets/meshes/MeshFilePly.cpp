// The reader of PLY files. It walks over the elements as the header lays them out. It is ours since
// OpenMesh's reads coordinates as floats, knows no triangle strips, and takes a truncated file for
// a whole one; VTK's crashed on damaged ones.
#include <algorithm>
#include <array>

#include "datasets/meshes/MeshFilePlyHeader.h"
#include "datasets/meshes/MeshFilePlyValues.h"
#include "datasets/meshes/MeshFileText.h"
#include "datasets/meshes/PolygonMesh.h"
#include "filters/core/support/Text.h"

namespace umbra::meshfile {
namespace {

constexpr std::array<std::string_view, 6> vertexProperties{"x", "y", "z", "nx", "ny", "nz"};

bool isIndexList(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

std::size_t countOf(const PlyElement& element, std::string_view name) {
  return std::size_t(
      std::count_if(element.properties.begin(), element.properties.end(),
                    [&](const PlyProperty& p) { return !p.count && p.name == name; }));
}

// Elements are told of so often.
constexpr std::size_t elementsBetween = 16384;

class PlyReader {
 public:
  PlyReader(std::string_view content, const std::string& name, const Progress& progress)
      : name_(name),
        progress_(progress),
        header_(readPlyHeader(content, name)),
        values_(content, header_.format),
        bytes_(values_.left()) {}

  PolygonMesh run() {
    findElements();
    for (const PlyElement& element : header_.elements) {
      element_ = &element;
      readElements();
      // The elements after the faces are not needed, and often are of unusual kinds.
      if (&element == last_ && header_.unknownLines == 0) break;
    }
    const bool wasLast = last_ == &header_.elements.back();
    if (wasLast && header_.unknownLines == 0 && values_.hasMore())
      mesh_.notes.push_back("what follows the promised values was left out");
    checkUnknownLines();
    return std::move(mesh_);
  }

 private:
  void findElements() {
    const PlyElement* faces = nullptr;
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex" && !vertex_) vertex_ = &element;
      const bool isFaces = element.name == "face", isStrips = element.name == "tristrips";
      if (!isFaces && !isStrips) continue;
      if (std::count_if(element.properties.begin(), element.properties.end(), isIndexList) != 1)
        refuse(name_, "has " + std::string(isFaces ? "faces" : "triangle strips") +
                          " without one list 'vertex_indices'");
      if (!faces) faces = &element;
      last_ = &element;
    }
    if (vertex_ && !faces) refuse(name_, "has points but no faces, so that it casts no shadow");
    if (!vertex_ || !faces || faces < vertex_)
      refuse(name_, "has no element 'vertex' followed by an element 'face'");
    for (std::string_view name : vertexProperties)
      if (countOf(*vertex_, name) > 1)
        refuse(name_, "names the vertex property '" + std::string(name) + "' twice");
    for (std::string_view name : {"x", "y", "z"})
      if (countOf(*vertex_, name) == 0) refuse(name_, "has vertices without x, y and z");
    faces_ = faces->count;
    hasNormals_ = countOf(*vertex_, "nx") + countOf(*vertex_, "ny") + countOf(*vertex_, "nz") == 3;
  }

  void readElements() {
    if (element_->properties.empty()) return;  // whatever its count, it takes no bytes
    // Each has a byte at least, so that a promise that cannot be kept takes no memory.
    if (element_ == vertex_)
      mesh_.positions.reserve(std::min<std::uint64_t>(element_->count, values_.left()));
    for (read_ = 0; read_ < element_->count; ++read_) {
      property_ = &element_->properties.front();
      if (read_ % elementsBetween == 0)
        progress_.tell(1.0 - double(values_.left()) / double(std::max<std::size_t>(bytes_, 1)));
      try {
        if (element_ == vertex_)
          readVertex();
        else
          readLists(element_->name == "face", element_->name == "tristrips");
      } catch (const PlyProblem& problem) {
        if (problem.atEnd) truncated();
        wrong(inLength_                 ? "list length"
              : isIndexList(*property_) ? "vertex"
                                        : property_->name,
              problem.found);
      }
    }
  }

  [[noreturn]] void truncated() const {
    refuse(name_, "is truncated: it promises " + std::to_string(vertex_->count) + " vertices and " +
                      std::to_string(faces_) + " faces, but ends after " + std::to_string(read_) +
                      " of " + std::to_string(element_->count) + " '" + clipped(element_->name) +
                      "'");
  }

  [[noreturn]] void wrong(const std::string& what, std::string_view found) const {
    refuse(name_, "has a " + clipped(element_->name) + " (number " + std::to_string(read_) +
                      ") whose " + clipped(what) + " is '" + clipped(found) + "'");
  }

  void readVertex() {
    Eigen::Vector3d position, normal;
    for (const PlyProperty& property : element_->properties) {
      property_ = &property;
      const auto known = std::find(vertexProperties.begin(), vertexProperties.end(), property.name);
      const std::ptrdiff_t place = known - vertexProperties.begin();
      if (property.count || place == 6)
        values_.skip(property.type, property.count ? listLength() : 1);
      else
        (place < 3 ? position[place] : normal[place - 3]) = values_.real(property.type);
    }
    mesh_.positions.push_back(position);
    if (hasNormals_) mesh_.setNormal(std::uint32_t(read_), normal);
  }

  void readLists(bool isFace, bool isStrip) {
    for (const PlyProperty& property : element_->properties) {
      property_ = &property;
      const std::uint64_t length = property.count ? listLength() : 1;
      if (!isIndexList(property) || (!isFace && !isStrip))
        values_.skip(property.type, length);
      else if (isFace)
        readFace(length);
      else
        readStrip(length);
    }
  }

  std::uint64_t listLength() {
    inLength_ = true;
    const std::int64_t length = values_.whole(*property_->count);
    if (length < 0) wrong("list length", std::to_string(length));
    inLength_ = false;
    if (std::uint64_t(length) > values_.left()) truncated();  // a byte an entry at least
    return std::uint64_t(length);
  }

  std::uint32_t checkedIndex(std::int64_t index) const {
    if (index < 0 || index >= std::int64_t(mesh_.positions.size()))
      refuse(name_, "has a " + element_->name + " (number " + std::to_string(read_) +
                        ") that refers to vertex " + std::to_string(index) + "; the file has " +
                        std::to_string(mesh_.positions.size()) + ", counted from 0");
    return std::uint32_t(index);
  }

  void readFace(std::uint64_t length) {
    for (std::uint64_t i = 0; i < length; ++i)
      mesh_.corners.push_back(checkedIndex(values_.whole(property_->type)));
    mesh_.endFace();
  }

  // Each vertex from the third on makes a triangle with the two before it, every other one turned
  // round; −1 begins a new strip.
  void readStrip(std::uint64_t length) {
    std::array<std::uint32_t, 2> before{};
    std::uint64_t inStrip = 0;
    for (std::uint64_t i = 0; i < length; ++i) {
      const std::int64_t index = values_.whole(property_->type);
      if (index == -1) {
        inStrip = 0;
        continue;
      }
      const std::uint32_t vertex = checkedIndex(index);
      if (inStrip >= 2) {
        const bool turned = inStrip % 2 == 1;
        mesh_.corners.insert(mesh_.corners.end(), {before[turned], before[!turned], vertex});
        mesh_.endFace();
      }
      before = {before[1], vertex};
      ++inStrip;
    }
  }

  // A line that was passed over may have laid out values: then the body does not end where it
  // should.
  void checkUnknownLines() {
    if (header_.unknownLines == 0) return;
    if (values_.hasMore())
      refuse(name_, "has a line in its header that cannot be read, '" + header_.firstUnknown +
                        "', and values that the other lines do not describe");
    mesh_.notes.push_back(
        "lines of the header that begin with no word of the format were passed "
        "over: " +
        std::to_string(header_.unknownLines) + ", the first is '" + header_.firstUnknown + "'");
  }

  const std::string& name_;
  const Progress progress_;
  PlyHeader header_;
  PlyValues values_;
  std::size_t bytes_ = 0;  // of all values
  const PlyElement *vertex_ = nullptr, *last_ = nullptr, *element_ = nullptr;
  const PlyProperty* property_ = nullptr;
  std::uint64_t faces_ = 0, read_ = 0;  // elements of the kind `element_` so far
  bool hasNormals_ = false, inLength_ = false;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh readPly(std::string_view content, const std::string& name, const Progress& progress) {
  std::string converted;
  return PlyReader(plainText(content, converted), name, progress).run();
}

}  // namespace umbra::meshfile
