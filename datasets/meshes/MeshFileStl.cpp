// The reader of STL files. It is ours since OpenMesh's reads a file as text by its first word, and
// knows no parts.
#include <array>
#include <cstring>

#include "datasets/meshes/MeshFileText.h"
#include "datasets/meshes/PolygonMesh.h"

namespace umbra::meshfile {
namespace {

using Eigen::Vector3d;

void addVertex(PolygonMesh& mesh, const Vector3d& position) {
  mesh.corners.push_back(std::uint32_t(mesh.positions.size()));
  mesh.positions.push_back(position);
}

// Words in any case, one after the other; what is between known ones is passed over.
class StlText {
 public:
  StlText(std::string_view text, const std::string& name, const Progress& progress)
      : lines_(text, TextLines::Backslash::IsText, progress), name_(name) {}

  PolygonMesh run() {
    for (std::string key = word(); !key.empty(); key = word()) {
      // Some programs write "end facet" for "endfacet".
      if (key == "end") key += word();
      if (key == "solid" || key == "endsolid") {
        isOpen_ = key == "solid";
        const std::string_view title = trimmed(left_);
        left_ = {};
        if (isOpen_) mesh_.beginPart({std::string(title), ""});
      } else if (key == "outer") {
        readLoop();
      }
      begun_ += key == "facet";
      ended_ += key == "endfacet";
    }
    if (isOpen_ || begun_ != ended_)
      refuse(name_, "is truncated: it begins " + std::to_string(begun_) + " facets and ends " +
                        std::to_string(ended_) + (isOpen_ ? ", and has no 'endsolid'" : ""));
    return std::move(mesh_);
  }

 private:
  // The next word in small letters, empty at the end.
  std::string word() { return lowered(rawWord()); }
  std::string_view rawWord() {
    std::string_view found = nextWord(left_);
    while (found.empty()) {
      const std::optional<std::string_view> line = lines_.next();
      if (!line) return {};
      left_ = *line;
      found = nextWord(left_);
    }
    return found;
  }

  // "loop", then "vertex x y z" three times or more, then "endloop".
  void readLoop() {
    if (word() != "loop") refuseLine(name_, lines_.number(), "has 'outer' without 'loop'");
    std::size_t corners = 0;
    for (std::string key = word(); key != "endloop"; key = word(), ++corners) {
      if (key == "end" && word() == "loop") break;
      if (key.empty()) refuse(name_, "is truncated: it ends inside a facet");
      Vector3d position;
      bool right = key == "vertex";
      for (int i = 0; i < 3 && right; ++i) {
        const std::optional<double> value = realFrom(rawWord());
        right = value.has_value();
        position[i] = value.value_or(0.0);
      }
      if (!right) refuseLine(name_, lines_.number(), "is not 'vertex' and three numbers");
      addVertex(mesh_, position);
    }
    if (corners < 3)
      refuseLine(name_, lines_.number(), "ends a facet of fewer than three vertices");
    mesh_.endFace();
  }

  TextLines lines_;
  const std::string& name_;
  std::string_view left_;  // what is yet to be read of a line
  bool isOpen_ = false;
  std::size_t begun_ = 0, ended_ = 0;
  PolygonMesh mesh_;
};

constexpr std::size_t stlHeader = 84, stlFacet = 50;

std::uint32_t promisedFacets(std::string_view content) {
  std::uint32_t promised = 0;
  for (std::size_t i = 0; i < 4; ++i)
    promised |= std::uint32_t(static_cast<unsigned char>(content[80 + i])) << (8 * i);
  return promised;
}

// Whether the length is that of a binary file with the count that it names.
bool hasBinaryLength(std::string_view content) {
  return content.size() >= stlHeader &&
         content.size() == stlHeader + std::size_t(promisedFacets(content)) * stlFacet;
}

// Programs that write while they go leave the count at 0 or at all ones.
bool isPlaceholder(std::uint32_t count) {
  return count == 0 || count == UINT32_MAX;
}

PolygonMesh readStlBinary(std::string_view content, const std::string& name,
                          const Progress& progress) {
  if (content.size() < stlHeader)
    refuse(name, "is no STL file, or truncated: one has 84 bytes or more, or begins with 'solid'");
  const std::uint32_t promised = promisedFacets(content);
  const std::size_t there = (content.size() - stlHeader) / stlFacet;
  const bool byLength = isPlaceholder(promised) && there > 0;
  if (there < promised && !byLength)
    refuse(name, "is truncated: it promises " + std::to_string(promised) + " facets, but has " +
                     std::to_string(there));
  const std::size_t facets = byLength ? there : promised;
  PolygonMesh mesh;
  if (byLength)
    mesh.notes.push_back("the header promises " + std::to_string(promised) +
                         " facets; all that the file's length holds were read, " +
                         std::to_string(there));
  else if (content.size() > stlHeader + facets * stlFacet)
    mesh.notes.push_back(std::to_string(content.size() - stlHeader - facets * stlFacet) +
                         " bytes that follow the promised facets were left out");
  mesh.positions.reserve(3 * facets);
  for (std::size_t facet = 0; facet < facets; ++facet) {
    progress.step(facet, facets);
    std::array<float, 9> values;
    // These follow the normal. They are little-endian, as this machine's are.
    std::memcpy(values.data(), content.data() + stlHeader + facet * stlFacet + 12, sizeof values);
    for (std::size_t i = 0; i < 9; i += 3)
      addVertex(mesh, Vector3d(values[i], values[i + 1], values[i + 2]));
    mesh.endFace();
  }
  return mesh;
}

// A binary file's header may begin with "solid", too, even with "solid facet".
bool isText(std::string_view content, std::string_view text) {
  if (hasBinaryLength(content)) return false;
  while (!text.empty() && trimmed(text.substr(0, 1)).empty()) text.remove_prefix(1);
  const std::string first = lowered(text.substr(0, 5));
  if (first != "solid" && first != "facet") return false;
  return text.substr(0, 1000).find('\0') == std::string_view::npos;
}

}  // namespace

PolygonMesh readStl(std::string_view content, const std::string& name, const Progress& progress) {
  std::string converted;
  const std::string_view text = plainText(content, converted);
  return isText(content, text) ? StlText(text, name, progress).run()
                               : readStlBinary(content, name, progress);
}

}  // namespace umbra::meshfile
