// The reader of OFF files, as Geomview describes them. It is ours since OpenMesh's reads
// coordinates as floats and takes a truncated file for a whole one.
#include <algorithm>

#include "datasets/meshes/MeshFileText.h"
#include "datasets/meshes/PolygonMesh.h"
#include "filters/core/support/Text.h"

namespace umbra::meshfile {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name, const Progress& progress)
      : lines_(text, TextLines::Backslash::IsText, progress), name_(name) {}

  PolygonMesh run() {
    readKey();
    readCounts();
    for (read_ = 0; read_ < vertices_; ++read_) readVertex();
    for (read_ = 0; read_ < faces_; ++read_) readFace();
    return std::move(mesh_);
  }

 private:
  // "OFF" with letters before it that say what a vertex has beside its position. The counts may
  // follow at once, as in the ModelNet collection's "OFF8 6 12"; the word may be missing.
  void readKey() {
    const std::optional<std::string_view> line = lines_.nextWithWords();
    if (!line) refuse(name_, "is no OFF file: it is empty");
    left_ = *line;
    std::string_view words = left_;
    const std::string_view word = nextWord(words);
    if (wholeFrom(word)) return;
    const std::size_t end = word.find("OFF");
    const std::string_view letters = word.substr(0, end),
                           digits = word.substr(std::min(word.size(), end + 3));
    const bool known = end != std::string_view::npos &&
                       letters.find_first_not_of("STCN4n") == std::string_view::npos &&
                       (digits.empty() || wholeFrom(digits));
    if (!known || letters.find_first_of("4n") != std::string_view::npos)
      refuse(name_, "is no OFF file of points in space; those begin with 'OFF'");
    hasNormals_ = letters.find('N') != std::string_view::npos;
    hasExtras_ = letters.find_first_of("CST") != std::string_view::npos;
    left_ = digits.empty() ? words : left_.substr(std::size_t(digits.data() - left_.data()));
    std::string_view after = left_;
    if (nextWord(after) == "BINARY")
      refuse(name_, "is a binary OFF file; save it as text, or as PLY");
  }

  // The next word, if need be of the next line that has one.
  std::string_view word() {
    std::string_view found = nextWord(left_);
    while (found.empty()) {
      const std::optional<std::string_view> line = lines_.nextWithWords();
      if (!line) return {};
      left_ = *line;
      found = nextWord(left_);
    }
    return found;
  }

  void readCounts() {
    const auto vertices = wholeFrom(word());
    const bool onOneLine = !trimmed(left_).empty();
    const auto faces = wholeFrom(word());
    if (!vertices || !faces || *vertices < 0 || *faces < 0)
      refuse(name_, "does not say how many vertices and faces it has");
    vertices_ = std::size_t(*vertices);
    faces_ = std::size_t(*faces);
    // Then follows the number of edges, which many files give as 0 and some leave out.
    if (!onOneLine && trimmed(left_).empty()) word();
    left_ = {};
  }

  [[noreturn]] void truncated(const char* what) const {
    refuse(name_, "is truncated: it promises " + std::to_string(vertices_) + " vertices and " +
                      std::to_string(faces_) + " faces, but ends after " + std::to_string(read_) +
                      " " + what + "; each has a line of its own");
  }

  Eigen::Vector3d vector() {
    Eigen::Vector3d vector;
    for (int i = 0; i < 3; ++i) {
      const std::string_view found = word();
      if (found.empty()) truncated("vertices");
      const std::optional<double> value = realFrom(found);
      if (!value) refuseLine(name_, lines_.number(), "is not a vertex, three numbers");
      vector[i] = *value;
    }
    return vector;
  }

  void readVertex() {
    mesh_.positions.push_back(vector());
    if (hasNormals_) mesh_.setNormal(std::uint32_t(read_), vector());
    if (!trimmed(left_).empty() && !hasExtras_ && read_ == 0)
      mesh_.notes.push_back(
          "its vertices have more numbers than its first word says; these were left out");
    left_ = {};  // colours and texture coordinates
  }

  void readFace() {
    const std::string_view first = word();
    if (first.empty()) truncated("faces");
    const std::int64_t corners = wholeFrom(first).value_or(-1);
    if (corners < 0)
      refuseLine(name_, lines_.number(),
                 "has a face that begins with '" + clipped(first) +
                     "', which is not a number of vertices");
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::string_view found = word();
      const std::int64_t index = wholeFrom(found).value_or(-1);
      if (index < 0 || index >= std::int64_t(vertices_))
        refuseLine(name_, lines_.number(),
                   "has a face of " + std::to_string(corners) +
                       " vertices that refers to vertex '" + clipped(found) + "'; the file has " +
                       std::to_string(vertices_) + ", counted from 0");
      mesh_.corners.push_back(std::uint32_t(index));
    }
    mesh_.endFace();
    left_ = {};  // a colour
  }

  TextLines lines_;
  const std::string& name_;
  std::string_view left_;  // what is yet to be read of a line
  bool hasNormals_ = false, hasExtras_ = false;
  std::size_t vertices_ = 0, faces_ = 0, read_ = 0;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh readOff(std::string_view content, const std::string& name, const Progress& progress) {
  std::string converted;
  return OffReader(plainText(content, converted), name, progress).run();
}

}  // namespace umbra::meshfile
