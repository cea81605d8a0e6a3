// The checks of OFF and STL files.
#include <array>
#include <cmath>
#include <cstring>

#include "datasets/meshes/MeshFileCheck.h"
#include "datasets/meshes/MeshFileText.h"

namespace umbra {
namespace {

using namespace meshfile;

// The lines that are not empty, without comments.
class Lines {
 public:
  explicit Lines(std::string_view content) : rest_(content) {}

  std::optional<std::string_view> next() {
    while (auto line = nextLine(rest_)) {
      ++number_;
      *line = line->substr(0, line->find('#'));
      std::string_view words = *line;
      if (!nextWord(words).empty()) return line;
    }
    return std::nullopt;
  }
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

void offCounts(Lines& lines, const std::string& name, CheckedMesh& mesh) {
  std::optional<std::string_view> line = lines.next();
  const std::string_view key = line ? nextWord(*line) : std::string_view();
  if (!key.ends_with("OFF") || key.find_first_of("4n") != std::string_view::npos)
    refuse(name, "is no OFF file of points in space; those begin with 'OFF'");
  std::string_view first = line ? nextWord(*line) : std::string_view();
  if (first == "BINARY") refuse(name, "is a binary OFF file; save it as text, or as PLY");
  if (first.empty()) {
    line = lines.next();
    first = line ? nextWord(*line) : std::string_view();
  }
  const auto vertices = wholeFrom(first), faces = wholeFrom(line ? nextWord(*line) : "");
  if (!vertices || !faces || *vertices < 0 || *faces < 0)
    refuse(name, "does not say how many vertices and faces it has");
  mesh.vertices = std::size_t(*vertices);
  mesh.faces = std::size_t(*faces);
}

[[noreturn]] void truncated(const std::string& name, const CheckedMesh& mesh, std::size_t read,
                            const char* what) {
  refuse(name, "is truncated: it promises " + std::to_string(mesh.vertices) + " vertices and " +
                   std::to_string(mesh.faces) + " faces, but ends after " + std::to_string(read) +
                   " " + what);
}

void copyOffFace(std::string_view line, std::size_t number, const std::string& name,
                 CheckedMesh& mesh) {
  const std::int64_t corners = wholeFrom(nextWord(line)).value_or(0);
  if (corners < 3) refuseLine(name, number, "has a face of fewer than three vertices");
  mesh.content += std::to_string(corners);
  for (std::int64_t i = 0; i < corners; ++i) {
    const std::string_view word = nextWord(line);
    const std::int64_t index = wholeFrom(word).value_or(-1);
    if (index < 0 || index >= std::int64_t(mesh.vertices))
      refuseLine(name, number,
                 "has a face of " + std::to_string(corners) + " vertices that refers to vertex '" +
                     std::string(word) + "'; the file has " + std::to_string(mesh.vertices) +
                     ", counted from 0");
    (mesh.content += ' ') += std::to_string(index);
  }
  mesh.content += '\n';
}

// One facet of a text STL file: three lines "vertex x y z" after "outer loop".
void copyStlLoop(Lines& lines, const std::string& name, CheckedMesh& mesh) {
  std::string loop = "outer loop\n";
  bool finite = true;
  for (int i = 0; i < 3; ++i) {
    std::optional<std::string_view> line = lines.next();
    if (!line) refuse(name, "is truncated: it ends inside a facet");
    const bool isVertex = nextWord(*line) == "vertex";
    loop += "vertex";
    const std::optional<bool> point = isVertex ? copyVector(*line, loop) : std::nullopt;
    if (!point) refuseLine(name, lines.number(), "is not 'vertex' and three numbers");
    loop += '\n';
    finite = finite && *point;
  }
  if (finite) {
    mesh.content += loop;
    ++mesh.faces;
  } else {
    ++mesh.nonFiniteFaces;
  }
}

CheckedMesh checkStlText(const std::string& content, const std::string& name) {
  CheckedMesh mesh;
  Lines lines(content);
  lines.next();  // "solid" and a name
  std::size_t begun = 0, ended = 0;
  bool whole = false;
  while (auto line = lines.next()) {
    const std::string_view key = nextWord(*line);
    if (key == "outer") copyStlLoop(lines, name, mesh);
    begun += key == "facet";
    ended += key == "endfacet";
    whole = key == "endsolid";
  }
  if (!whole || begun != ended)
    refuse(name, "is truncated: it begins " + std::to_string(begun) + " facets and ends " +
                     std::to_string(ended) + (whole ? "" : ", and has no 'endsolid'"));
  return mesh;
}

constexpr std::size_t stlHeader = 84, stlFacet = 50;

CheckedMesh checkStlBinary(const std::string& content, const std::string& name) {
  std::uint32_t promised = 0;
  if (content.size() < stlHeader) refuse(name, "is truncated: an STL file has 84 bytes or more");
  for (std::size_t i = 0; i < 4; ++i)
    promised |= std::uint32_t(static_cast<unsigned char>(content[80 + i])) << (8 * i);
  const std::size_t there = (content.size() - stlHeader) / stlFacet;
  if (there < promised)
    refuse(name, "is truncated: it promises " + std::to_string(promised) + " facets, but has " +
                     std::to_string(there));
  CheckedMesh mesh;
  mesh.binary = true;
  mesh.content = content.substr(0, stlHeader);
  for (std::size_t facet = 0; facet < promised; ++facet) {
    const char* start = content.data() + stlHeader + facet * stlFacet;
    std::array<float, 9> corners;
    // This follows the normal. The reader assumes that the bytes are in this machine's order, and
    // so does this check.
    std::memcpy(corners.data(), start + 12, sizeof corners);
    bool finite = true;
    for (float value : corners) finite = finite && std::isfinite(value);
    finite ? void(mesh.content.append(start, stlFacet)) : void(++mesh.nonFiniteFaces);
    mesh.faces += finite;
  }
  for (std::size_t i = 0; i < 4; ++i) mesh.content[80 + i] = char(mesh.faces >> (8 * i) & 0xff);
  return mesh;
}

}  // namespace

CheckedMesh checkOff(const std::string& content, const std::string& name) {
  CheckedMesh mesh;
  Lines lines(content);
  offCounts(lines, name, mesh);
  mesh.content =
      "OFF\n" + std::to_string(mesh.vertices) + " " + std::to_string(mesh.faces) + " 0\n";
  for (std::size_t i = 0; i < mesh.vertices; ++i) {
    std::optional<std::string_view> line = lines.next();
    if (!line) truncated(name, mesh, i, "vertices");
    const std::optional<bool> finite = copyVector(*line, mesh.content);
    if (!finite) refuseLine(name, lines.number(), "is not a vertex, three numbers");
    mesh.content += '\n';
    if (!*finite) mesh.nonFinite.push_back(std::uint32_t(i));
  }
  for (std::size_t i = 0; i < mesh.faces; ++i) {
    const std::optional<std::string_view> line = lines.next();
    if (!line) truncated(name, mesh, i, "faces");
    copyOffFace(*line, lines.number(), name, mesh);
  }
  return mesh;
}

CheckedMesh checkStl(const std::string& content, const std::string& name) {
  // Binary files may begin with "solid" too, but those hold no line that begins with "facet".
  const bool text = content.starts_with("solid") && (content.find("facet") != std::string::npos ||
                                                     content.find("endsolid") != std::string::npos);
  return text ? checkStlText(content, name) : checkStlBinary(content, name);
}

}  // namespace umbra
