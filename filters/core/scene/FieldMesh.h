// Triangles with named values at their vertices and on their faces, for mesh files.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace umbra {

struct MeshField {
  std::string name;           // one word: "bleeding"
  std::vector<float> values;  // one for each vertex, or for each face
};

struct FieldMesh {
  std::vector<Eigen::Vector3f> positions;  // world
  std::vector<Eigen::Vector3f> normals;    // one unit vector for each position
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<MeshField> vertexFields, faceFields;
  // The object that each face belongs to, and the names of these objects.
  std::vector<std::uint32_t> objects;
  std::vector<std::string> objectNames;
};

}  // namespace umbra
