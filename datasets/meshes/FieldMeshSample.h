// A mesh with fields, for the tests of its files.
#pragma once

#include "filters/core/scene/FieldMesh.h"

namespace umbra {

// Two triangles that belong to two of three objects; the object between them has no triangle.
inline FieldMesh sampleFieldMesh() {
  FieldMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0.25f}, {0, 1, 0}, {1, 1, 0}};
  mesh.normals.assign(4, Eigen::Vector3f::UnitZ());
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  mesh.vertexFields = {{"error", {0.5f, -0.25f, 0.0f, 1.0f}}, {"bleeding", {0.5f, 0, 0, 1}}};
  mesh.faceFields = {{"bleeding", {0.125f, 0.0f}}, {"area", {0.5f, 0.75f}}};
  mesh.objects = {0, 2};
  mesh.objectNames = {"bench", "lawn", "tree"};
  return mesh;
}

}  // namespace umbra
