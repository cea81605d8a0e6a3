// What a reader of a mesh file finds, before polygons are cut into triangles.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "filters/core/scene/Scene.h"
#include "filters/core/support/Progress.h"

namespace umbra::meshfile {

// What a file calls a set of its faces; an empty name where it calls them nothing.
struct MeshPart {
  std::string object;  // OBJ's "o" or "g", STL's "solid", a node of glTF
  std::string material;

  bool operator<(const MeshPart& other) const {
    return std::tie(object, material) < std::tie(other.object, other.material);
  }
  bool operator==(const MeshPart&) const = default;
};

// Polygons in the file's own coordinates and order, all in double: coordinates of a map's grid have
// seven digits before those that make a shape. Indices may yet be wrong, positions not finite.
class PolygonMesh {
 public:
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3f> normals;  // unit or zero, one for each position; empty: none given
  std::vector<std::uint32_t> corners;    // of all faces, one after the other
  std::vector<std::size_t> faceEnds;     // where the corners of each face end
  std::vector<std::uint32_t> faceParts;  // the index of each face's part; empty: all of part 0
  std::vector<MeshPart> parts{{}};
  std::map<std::string, Material> materials;  // by name, where the file itself has them
  // A vertex that was given two different normals lies on a crease, which one normal cannot show.
  bool hasCreases = false;
  std::size_t shortFaces = 0;      // that were left out, since they have fewer than three vertices
  std::size_t nonFiniteFaces = 0;  // that were left out by the reader
  std::vector<std::string> notes;  // one sentence for each doubtful reading

  std::size_t faceCount() const { return faceEnds.size(); }
  std::span<const std::uint32_t> face(std::size_t f) const {
    const std::size_t start = f == 0 ? 0 : faceEnds[f - 1];
    return std::span(corners).subspan(start, faceEnds[f] - start);
  }
  // Ends the face whose corners were appended last. One of fewer than three is counted and dropped.
  void endFace() {
    const std::size_t start = faceEnds.empty() ? 0 : faceEnds.back();
    if (corners.size() - start < 3) {
      ++shortFaces;
      corners.resize(start);
      return;
    }
    faceEnds.push_back(corners.size());
    if (parts.size() > 1 || part_ > 0) {
      faceParts.resize(faceEnds.size() - 1);
      faceParts.push_back(part_);
    }
  }
  // The faces that follow belong to this part.
  void beginPart(const MeshPart& part) {
    const auto [found, isNew] = known_.try_emplace(part, std::uint32_t(parts.size()));
    if (isNew) parts.push_back(part);
    part_ = found->second;
  }
  // Gives a vertex a normal of any length; one that is not finite or zero counts as none.
  void setNormal(std::uint32_t vertex, const Eigen::Vector3d& given) {
    if (vertex >= positions.size() || !given.allFinite() || !(given.norm() > 0.0)) return;
    normals.resize(positions.size(), Eigen::Vector3f::Zero());
    const Eigen::Vector3f unit = given.normalized().cast<float>();
    Eigen::Vector3f& normal = normals[vertex];
    hasCreases = hasCreases || (normal.squaredNorm() > 0.0f && normal.dot(unit) < 0.999f);
    normal = unit;
  }

 private:
  std::map<MeshPart, std::uint32_t> known_{{{}, 0}};
  std::uint32_t part_ = 0;
};

// The readers. Messages call the file `name`. All throw BadInput where the content is no mesh of
// that format, or is truncated, with what was read and what was promised.
PolygonMesh readObj(std::string_view content, const std::string& name,
                    const Progress& progress = {});
PolygonMesh readPly(std::string_view content, const std::string& name,
                    const Progress& progress = {});
PolygonMesh readOff(std::string_view content, const std::string& name,
                    const Progress& progress = {});
PolygonMesh readStl(std::string_view content, const std::string& name,
                    const Progress& progress = {});
PolygonMesh readGltf(std::string_view content, const std::string& name,
                     const Progress& progress = {});

}  // namespace umbra::meshfile
