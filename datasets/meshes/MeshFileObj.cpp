// The reader of OBJ files. It is ours since OpenMesh's reads coordinates as floats, knows no parts,
// and takes what it cannot read for 0. Such a file promises no count, so that one that was cut at a
// line's end looks whole; a face whose vertices are missing is found.
#include "datasets/meshes/MeshFileText.h"
#include "datasets/meshes/PolygonMesh.h"
#include "filters/core/support/Text.h"

namespace umbra::meshfile {
namespace {

using Eigen::Vector3d;

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name, const Progress& progress)
      : text_(text), name_(name), progress_(progress) {}

  PolygonMesh run() {
    if (text_.substr(0, 256).find('\0') != std::string_view::npos)
      refuse(name_,
             "holds zero bytes where text should be, as UTF-16 without its mark does; save it "
             "as UTF-8");
    readVectors();
    if (!normals_.empty()) mesh_.normals.assign(mesh_.positions.size(), Eigen::Vector3f::Zero());
    readFaces();
    if (badVectors_ > 0)
      mesh_.notes.push_back(std::to_string(badVectors_) +
                            " vertices or normals hold what is not a number, the first in line " +
                            std::to_string(firstBad_));
    return std::move(mesh_);
  }

 private:
  // Faces may refer to vertices that follow them, so that these are read first.
  void readVectors() {
    TextLines lines(text_, TextLines::Backslash::Joins, progress_.stage(0.0, 0.5));
    while (auto line = lines.next()) {
      const std::string_view key = nextWord(*line);
      if (key == "v") mesh_.positions.push_back(vector(key, *line, lines.number()));
      if (key == "vn") normals_.push_back(vector(key, *line, lines.number()));
    }
  }

  Vector3d vector(std::string_view key, std::string_view line, std::size_t number) {
    std::string_view words = line;
    if (const std::optional<Vector3d> value = vectorFrom(line)) return *value;
    for (int i = 0; i < 3; ++i)
      if (nextWord(words).empty())
        refuseLine(name_, number, "has no three numbers after '" + std::string(key) + "'");
    if (badVectors_++ == 0) firstBad_ = number;
    return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }

  void readFaces() {
    TextLines lines(text_, TextLines::Backslash::Joins, progress_.stage(0.5, 1.0));
    while (auto line = lines.next()) {
      const std::string_view key = nextWord(*line);
      if (key == "v") {
        ++verticesSoFar_;
      } else if (key == "vn") {
        ++normalsSoFar_;
      } else if (key == "f") {
        // A comment may follow an index without a blank.
        face(line->substr(0, line->find('#')), lines.number());
      } else if (key == "o" || key == "g") {
        part_.object = trimmed(*line);
        mesh_.beginPart(part_);
      } else if (key == "usemtl") {
        part_.material = trimmed(*line);
        mesh_.beginPart(part_);
      }
    }
  }

  // The index, from 0, that a reference such as "12" or "-1" means.
  std::uint32_t resolved(std::string_view word, std::size_t soFar, std::size_t all,
                         const char* what, std::size_t line) const {
    const std::optional<std::int64_t> given = wholeFrom(word);
    const std::int64_t index =
        given ? (*given < 0 ? std::int64_t(soFar) + *given : *given - 1) : -1;
    if (index < 0 || index >= std::int64_t(all))
      refuseLine(name_, line,
                 "has a face that refers to " + std::string(what) + " '" + clipped(word) +
                     "'; the file has " + std::to_string(all));
    return std::uint32_t(index);
  }

  void face(std::string_view line, std::size_t number) {
    for (std::string_view corner = nextWord(line); !corner.empty(); corner = nextWord(line)) {
      const std::size_t slash = corner.find('/'), last = corner.rfind('/');
      const std::uint32_t vertex = resolved(corner.substr(0, slash), verticesSoFar_,
                                            mesh_.positions.size(), "vertex", number);
      mesh_.corners.push_back(vertex);
      if (last != slash && last + 1 < corner.size())
        mesh_.setNormal(vertex, normals_[resolved(corner.substr(last + 1), normalsSoFar_,
                                                  normals_.size(), "normal", number)]);
    }
    mesh_.endFace();
  }

  std::string_view text_;
  const std::string& name_;
  const Progress progress_;
  PolygonMesh mesh_;
  std::vector<Vector3d> normals_;
  MeshPart part_;
  std::size_t verticesSoFar_ = 0, normalsSoFar_ = 0, badVectors_ = 0, firstBad_ = 0;
};

}  // namespace

PolygonMesh readObj(std::string_view content, const std::string& name, const Progress& progress) {
  std::string converted;
  return ObjReader(plainText(content, converted), name, progress).run();
}

}  // namespace umbra::meshfile
