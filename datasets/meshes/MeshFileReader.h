// Reads a checked mesh.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/meshes/MeshFile.h"
#include "datasets/meshes/MeshFileCheck.h"

namespace umbra::meshfile {

// Triangles in the file's own coordinates and order; indices are valid, positions finite.
struct RawMesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;  // unit, one for each position; empty where absent
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> triangleMaterials;  // indices of `materials`
  std::vector<std::string> materials;
  MeshReport report;
};

// `extension` (".obj") says which format `content` has; messages call the file `name`. Throws
// BadInput.
RawMesh readMesh(const std::string& content, const std::string& extension, const std::string& name);

// A mesh with normals: the file's or, where it has none, computed ones. For these, equal positions
// count as one vertex, since models often have doubled vertices along their creases.
Mesh withItsNormals(const RawMesh& raw);

}  // namespace umbra::meshfile
