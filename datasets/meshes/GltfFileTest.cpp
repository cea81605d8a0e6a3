// What a glTF file may do beside holding triangles: place them, name them, lie about its buffers,
// and point to other files.
#include "datasets/meshes/GltfFile.h"

#include <gtest/gtest.h>

#include <fstream>

#include "datasets/meshes/MeshFileReader.h"
#include "datasets/meshes/MeshFileSamples.h"
#include "datasets/scenes/MeshScene.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;
using namespace meshsamples;

class Gltf : public testing::Test {
 protected:
  fs::path put(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  std::string refusal(const std::string& content) const {
    try {
      readMeshFile(put("a.gltf", content));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      return error.what();
    }
    ADD_FAILURE() << "was accepted: " << content;
    return "";
  }

  const TemporaryFolder folder_;
};

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

#define EXPECT_HAS(message, part) EXPECT_NE((message).find(part), std::string::npos) << (message)

TEST_F(Gltf, PlacesANodeInItsParentsAndKeepsFacesOutward) {
  // A quarter turn about y takes x to −z; the mirror would turn faces inward if nobody looked.
  const std::string node =
      R"(, "name": "crate", "scale": [2, -1, 1], "rotation": [0, 0.70710678118654752, 0, 0.70710678118654752], "translation": [10, 0, 0])";
  const std::string parent = changed(cubeGltfText(node), R"("nodes": [{)",
                                     R"("nodes": [{"children": [1], "translation": [0, 5, 0]}, {)");
  const Mesh mesh = readMeshFile(put("a.gltf", parent));
  const Eigen::AlignedBox3d box = mesh.bounds();
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(10, 4, -2), 1e-6)) << box.min().transpose();
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(11, 5, 0), 1e-6)) << box.max().transpose();
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += mesh.positions[t[0]].cast<double>().dot(
                  mesh.positions[t[1]].cast<double>().cross(mesh.positions[t[2]].cast<double>())) /
              6.0;
  EXPECT_NEAR(volume, 2.0, 1e-5);
}

TEST_F(Gltf, NamesObjectsAndColoursThem) {
  const std::string text = changed(
      cubeGltfText(
          R"(, "name": "crate")",
          R"(, "materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0.2, 0, 1]}}])"),
      R"("indices": 1)", R"("indices": 1, "material": 0)");
  const Scene scene = sceneFromMeshFile(put("a.gltf", text));
  EXPECT_EQ(scene.objects[0].name, "crate");
  EXPECT_DOUBLE_EQ(scene.objects[0].material.colour.x(), 1.0);
  EXPECT_NEAR(scene.objects[0].material.colour.y(), 0.4845, 1e-4);  // linear 0.2 as sRGB
}

TEST_F(Gltf, ReadsABufferBesideItAndNoneElsewhere) {
  put("cube.bin", cubeBuffer());
  EXPECT_EQ(readMeshFile(put("a.gltf", cubeGltf(R"(, "uri": "cube.bin")"))).triangles.size(), 12u);
  fs::create_directory(folder_ / "inner");
  const fs::path inner = put("inner/a.gltf", cubeGltf(R"(, "uri": "../cube.bin")"));
  EXPECT_THROW(readMeshFile(inner), Error);
  EXPECT_HAS(refusal(cubeGltf(R"(, "uri": "/etc/passwd")")), "cannot be read as glTF");
  EXPECT_HAS(refusal(cubeGltf(R"(, "uri": "none.bin")")), "none.bin");
}

TEST_F(Gltf, RefusesWhatLiesOutsideOfItsBuffers) {
  const std::string text = cubeGltfText();
  EXPECT_HAS(refusal(changed(text, R"("count": 8)", R"("count": 9)")), "accessor 0 reaches beyond");
  EXPECT_HAS(refusal(changed(text, R"("byteOffset": 96)", R"("byteOffset": 97)")),
             "accessor 1 reaches beyond");
  EXPECT_HAS(refusal(changed(text, R"("count": 36)", R"("count": 4294967295)")), "reaches beyond");
  EXPECT_HAS(refusal(changed(text, R"("VEC3")", R"("VEC2")")), "should have 3 components");
  EXPECT_HAS(refusal(changed(text, R"("POSITION": 0)", R"("POSITION": 7)")), "accessor 7");
  EXPECT_HAS(refusal(changed(text, R"("mesh": 0)", R"("mesh": 3)")), "mesh 3");
  EXPECT_HAS(refusal(changed(text, R"("nodes": [0])", R"("nodes": [0, 0])")), "twice");
}

TEST_F(Gltf, KeepsOnlyTheVerticesThatAPartUses) {
  // Many parts that draw one triangle each out of one list, as exporters write materials.
  std::string parts;
  for (int i = 0; i < 50; ++i) parts += R"({"attributes": {"POSITION": 0}, "indices": 2},)";
  std::string text = changed(cubeGltfText(), R"("primitives": [)", R"("primitives": [)" + parts);
  text = changed(text, R"("bufferViews")", R"("unused": 0, "bufferViews")");
  text = changed(
      text, R"("type": "SCALAR"})",
      R"("type": "SCALAR"}, {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"})");
  const meshfile::RawMesh raw = meshfile::readRawMesh(put("a.gltf", text));
  EXPECT_EQ(raw.triangles.size(), 62u);
  EXPECT_EQ(raw.positions.size(), 8u + 50u * 3u);
}

TEST_F(Gltf, SaysWhatItDoesNotRead) {
  EXPECT_HAS(refusal(changed(cubeGltfText(), R"("2.0")", R"("1.0")")), "version 1.0");
  EXPECT_HAS(refusal(cubeGltfText("", R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])")),
             "KHR_draco_mesh_compression");
  EXPECT_HAS(refusal(cubeGltfText("", R"(, "extensionsRequired": ["ACME_shape"])")), "ACME_shape");
  EXPECT_NO_THROW(readMeshFile(
      put("a.gltf", cubeGltfText("", R"(, "extensionsRequired": ["KHR_materials_unlit"])"))));
  EXPECT_HAS(refusal("{}"), "no asset.version");
  EXPECT_HAS(refusal(std::string(100'000, '[')), "nested more than 64 levels");
  MeshReport report;
  readMeshFile(put("a.gltf", cubeGltfText("", R"(, "animations": [{}])")), &report);
  EXPECT_HAS(report.summary(), "before its animations");
}

}  // namespace
}  // namespace umbra
