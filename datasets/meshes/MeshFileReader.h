// Reads a mesh file's triangles and the parts that they belong to.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "datasets/meshes/MeshFile.h"
#include "datasets/meshes/PolygonMesh.h"

namespace umbra::meshfile {

using Triangle = std::array<std::uint32_t, 3>;

// Triangles in the file's own coordinates and order, in double; indices are valid, and positions of
// triangles finite.
struct RawMesh {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3f> normals;  // unit, one for each position; empty where absent
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> triangleParts;  // indices of `parts`
  std::vector<MeshPart> parts;
  std::map<std::string, Material> materials;  // by name, where the file itself has them
  MeshReport report;
};

// The extensions of files that are read, as a person reads them: ".obj .ply .off .stl".
std::string meshExtensions();
// Whether a name ends in one of them, in any case.
bool isMeshName(const std::filesystem::path& file);

// Whether the file's shape may lie in other files as well, as the buffers of glTF do.
bool mayReferToFiles(const std::filesystem::path& file);

// `extension` (".obj") says which format `content` has; messages call the file `name`. Throws
// BadInput.
RawMesh readMesh(std::string_view content, const std::string& extension, const std::string& name,
                 const Progress& progress = {});
// The same of a file on the disk.
RawMesh readRawMesh(const std::filesystem::path& file, const Progress& progress = {});

// Some of the mesh's triangles, moved by `placement` in double before they are stored as floats.
// Normals are the file's or, where it has none, computed ones. For these, equal positions count as
// one vertex, since models often have doubled vertices along their creases.
Mesh placedMesh(const RawMesh& raw, std::span<const Triangle> triangles,
                const Eigen::Affine3d& placement, const Progress& progress = {});

}  // namespace umbra::meshfile
