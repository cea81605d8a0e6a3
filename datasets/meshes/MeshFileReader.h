// A checked mesh, read.
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
  std::vector<std::uint32_t> triangleMaterials;  // into `materials`
  std::vector<std::string> materials;
  MeshReport report;
};

// `extension` (".obj") says which format `content` has, `name` stands for it in messages. Throws
// BadInput.
RawMesh readMesh(const std::string& content, const std::string& extension, const std::string& name);

// As a mesh with normals: the file's, else computed. Equal positions count as one vertex then, as
// models often come with vertices doubled along their creases.
Mesh withItsNormals(const RawMesh& raw);

}  // namespace umbra::meshfile
