#include "datasets/meshes/FieldMeshPly.h"

#include <gtest/gtest.h>

#include <fstream>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "datasets/meshes/FieldMeshSample.h"
#include "datasets/meshes/MeshFile.h"
#include "datasets/meshes/MeshFileExporter.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

class FieldMeshPly : public testing::Test {
 protected:
  const TemporaryFolder temporary;
  const fs::path& folder = temporary.path();
  const fs::path file = folder / "mesh.ply";
  FieldMesh mesh = sampleFieldMesh();

  static std::string textOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

using Triangles = OpenMesh::TriMesh_ArrayKernelT<>;

TEST_F(FieldMeshPly, OpenMeshFindsEveryFieldByItsName) {
  writePly(mesh, file);
  Triangles read;
  OpenMesh::IO::Options options(OpenMesh::IO::Options::Custom);
  ASSERT_TRUE(OpenMesh::IO::read_mesh(read, file.string(), options));
  ASSERT_EQ(read.n_vertices(), 4u);
  ASSERT_EQ(read.n_faces(), 2u);
  for (const MeshField& field : mesh.vertexFields) {
    OpenMesh::VPropHandleT<float> handle;
    ASSERT_TRUE(read.get_property_handle(handle, field.name)) << field.name;
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(read.property(handle, Triangles::VertexHandle(i)), field.values[std::size_t(i)]);
  }
  for (const MeshField& field : mesh.faceFields) {
    OpenMesh::FPropHandleT<float> handle;
    ASSERT_TRUE(read.get_property_handle(handle, field.name)) << field.name;
    for (int i = 0; i < 2; ++i)
      EXPECT_EQ(read.property(handle, Triangles::FaceHandle(i)), field.values[std::size_t(i)]);
  }
  OpenMesh::FPropHandleT<int> objects;
  ASSERT_TRUE(read.get_property_handle(objects, "object"));
  EXPECT_EQ(read.property(objects, Triangles::FaceHandle(1)), 2);
}

// MeshLab and Blender show what is called quality, and colours of vertices, at once.
TEST_F(FieldMeshPly, TheErrorIsQualityAndColour) {
  writePly(mesh, file);
  const std::string header = textOf(file);
  for (const char* property : {"property float quality", "property uchar red"})
    EXPECT_NE(header.find(property), std::string::npos) << property;
  Triangles read;
  OpenMesh::IO::Options options(OpenMesh::IO::Options::Custom);
  ASSERT_TRUE(OpenMesh::IO::read_mesh(read, file.string(), options));
  OpenMesh::VPropHandleT<float> quality;
  ASSERT_TRUE(read.get_property_handle(quality, "quality"));
  EXPECT_EQ(read.property(quality, Triangles::VertexHandle(1)), -0.25f);
  const meshfile::Exporter exporter(mesh);
  const auto colourOf = [&](int i) { return exporter.color(OpenMesh::VertexHandle(i)); };
  EXPECT_EQ(colourOf(2), OpenMesh::Vec3uc(255, 255, 255));  // no error
  EXPECT_GT(colourOf(3)[0], colourOf(3)[2]);                // light bleeds: red
  EXPECT_GT(colourOf(1)[2], colourOf(1)[0]);                // too dark: blue
}

TEST_F(FieldMeshPly, TheHeaderNamesFloats) {
  writePly(mesh, file);
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), {});
  text.resize(text.find("end_header"));
  EXPECT_NE(text.find("format binary_little_endian 1.0"), std::string::npos) << text;
  const std::size_t faces = text.find("element face 2");
  ASSERT_NE(faces, std::string::npos) << text;
  EXPECT_LT(text.find("property float bleeding"), faces) << text;
  EXPECT_NE(text.find("property float bleeding", faces), std::string::npos) << text;
  EXPECT_NE(text.find("property float area", faces), std::string::npos) << text;
  EXPECT_NE(text.find("property int object", faces), std::string::npos) << text;
}

// Three sheets share one edge, which half-edges cannot represent.
TEST_F(FieldMeshPly, WhatIsNoManifoldIsWrittenWhole) {
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 2}, {0, 1, 3}};
  mesh.objects.assign(4, 0);
  for (MeshField& field : mesh.faceFields) field.values.assign(4, 0.5f);
  writePly(mesh, file);
  const Mesh read = readMeshFile(file);
  ASSERT_EQ(read.triangles.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(read.positions[read.triangles[i][c]], mesh.positions[mesh.triangles[i][c]]);
}

TEST_F(FieldMeshPly, WhatCannotBeWrittenLeavesNothing) {
  writePly(mesh, file);
  EXPECT_THROW(writePly(mesh, file / "inside-a-file.ply"), Error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  EXPECT_EQ(readMeshFile(file).triangles.size(), 2u);
}

}  // namespace
}  // namespace umbra
