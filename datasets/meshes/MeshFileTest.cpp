#include "datasets/meshes/MeshFile.h"
#include "datasets/scenes/MeshScene.h"

#include <gtest/gtest.h>

#include <fstream>

#include "datasets/meshes/MeshFileSamples.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;
using namespace meshsamples;

class MeshFile : public testing::Test {
 protected:
  fs::path put(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  Mesh read(const std::string& name, const std::string& content) {
    return readMeshFile(put(name, content), &report_);
  }
  // The message of the error that reading must throw.
  std::string refusal(const std::string& name, const std::string& content) {
    try {
      read(name, content);
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      EXPECT_NE(message.find((folder_ / name).string()), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message;
    }
    ADD_FAILURE() << name << " was accepted";
    return "";
  }

  const TemporaryFolder temporary_;
  const fs::path& folder_ = temporary_.path();
  MeshReport report_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string withoutLastLine(const std::string& text) {
  return text.substr(0, text.rfind('\n', text.size() - 2) + 1);
}

double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.positions[t[0]].cast<double>();
    sum += a.dot(mesh.positions[t[1]].cast<double>().cross(mesh.positions[t[2]].cast<double>()));
  }
  return sum / 6.0;
}

#define EXPECT_SAYS(message, part) EXPECT_NE((message).find(part), std::string::npos) << (message)

TEST_F(MeshFile, ReadsTheSameCubeFromEveryFormat) {
  const std::pair<std::string, std::string> files[] = {
      {"a.obj", cubeObj()},           {"a.ply", cubePlyText()},   {"b.ply", cubePlyBinary()},
      {"c.PLY", cubePlyBinary(true)}, {"a.off", cubeOff()},       {"a.stl", cubeStlText()},
      {"b.STL", cubeStlBinary()},     {"a.gltf", cubeGltfText()}, {"a.glb", cubeGlb()}};
  for (const auto& [name, content] : files) {
    const Mesh mesh = read(name, content);
    SCOPED_TRACE(name);
    ASSERT_EQ(mesh.triangles.size(), 12u);
    // Three normals meet at each of eight corners.
    EXPECT_EQ(mesh.positions.size(), 24u);
    EXPECT_DOUBLE_EQ(volume(mesh), 1.0);  // every face looks outward
    EXPECT_TRUE(report_.normalsComputed);
    EXPECT_EQ(report_.degenerateFaces + report_.nonFiniteFaces, 0u);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const Eigen::Vector3f outward = mesh.positions[v] - Eigen::Vector3f::Constant(0.5f);
      EXPECT_FLOAT_EQ(mesh.normals[v].norm(), 1.0f);
      EXPECT_FLOAT_EQ(mesh.normals[v].dot(outward), 0.5f);
    }
  }
}

TEST_F(MeshFile, KeepsTheNormalsOfTheFile) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n"
      "0 0 0 0 3 4\n1 0 0 0 3 4\n0 1 0 0 3 4\n3 0 1 2\n";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nf 1//1 2//1 3//1\n";
  for (const auto& [name, content] : {std::pair("a.ply", ply), std::pair("a.obj", obj)}) {
    const Mesh mesh = read(name, content);
    EXPECT_FALSE(report_.normalsComputed) << name;
    ASSERT_EQ(mesh.normals.size(), 3u);
    for (const Eigen::Vector3f& normal : mesh.normals)
      EXPECT_TRUE(normal.isApprox(Eigen::Vector3f(0.0f, 0.6f, 0.8f))) << name;
  }
}

TEST_F(MeshFile, ComputesNormalsWhereAVertexHasSeveral) {
  const Mesh mesh = read("a.obj",
                         "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 0 1 0\n"
                         "f 1//1 2//1 3//1\nf 1//2 4//2 2//2\n");
  EXPECT_TRUE(report_.normalsComputed);
  EXPECT_EQ(mesh.positions.size(), 6u);  // the shared edge is a crease
}

TEST_F(MeshFile, CutsAHollowPolygonIntoTrianglesInsideIt) {
  // An arrow head that is concave at its fourth corner: a fan from the first corner would leave it.
  const Mesh mesh = read("a.obj", "v 0 2 0\nv -2 -2 0\nv 0 -1 0\nv 2 -2 0\nf 3 4 1 2\nf 2 3 4 1\n");
  ASSERT_EQ(mesh.triangles.size(), 4u);
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f a = mesh.positions[t[0]];
    const Eigen::Vector3f n = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
    EXPECT_GT(n.z(), 0.0f);
    area += 0.5 * n.norm();
  }
  EXPECT_DOUBLE_EQ(area, 2.0 * 6.0);
}

TEST_F(MeshFile, UnderstandsNegativeIndicesAndLongFaces) {
  const Mesh mesh =
      read("a.obj", "v 0 0 0\r\nv 1 0 0\r\nv 2 1 0\r\nv 1 2 0\r\nv 0 1 0\r\nf -5 -4 -3 -2 -1\r\n");
  EXPECT_EQ(mesh.triangles.size(), 3u);
}

TEST_F(MeshFile, DropsFacesWithoutAreaAndCountsThem) {
  read("a.obj", cubeObj() + "f 1 1 2\nf 1 2 1 2\nv 2 0 0\nf 1 2 9\n");
  EXPECT_EQ(report_.degenerateFaces, 3u);
  std::string stl = cubeStlText();
  stl = replaced(stl, "endsolid",
                 "facet normal 0 0 0\nouter loop\nvertex 1 1 1\nvertex 1 1 1\n"
                 "vertex 0 0 0\nendloop\nendfacet\nendsolid");
  EXPECT_EQ(read("a.stl", stl).triangles.size(), 12u);
  EXPECT_EQ(report_.degenerateFaces, 1u);
}

TEST_F(MeshFile, DropsFacesWithANumberThatIsNotFiniteAndCountsThem) {
  // Corner 0 belongs to three quads, six triangles of an STL file at most.
  const std::string zero = pointText(0);
  for (const std::string bad : {"nan 0 0", "0 -inf 0", "0 0 1e99"}) {
    EXPECT_EQ(read("a.obj", replaced(cubeObj(), zero, bad)).triangles.size(), 6u) << bad;
    EXPECT_EQ(report_.nonFiniteFaces, 3u);
    EXPECT_EQ(read("a.ply", replaced(cubePlyText(), zero, bad)).triangles.size(), 6u) << bad;
    EXPECT_EQ(report_.nonFiniteFaces, 3u);
    EXPECT_EQ(read("a.off", replaced(cubeOff(), zero, bad)).triangles.size(), 6u) << bad;
    EXPECT_EQ(report_.nonFiniteFaces, 3u);
    EXPECT_EQ(read("a.stl", replaced(cubeStlText(), zero, bad)).triangles.size(), 11u) << bad;
    EXPECT_EQ(report_.nonFiniteFaces, 1u);
  }
  std::string nan;
  appendBytes(nan, std::numeric_limits<float>::quiet_NaN());
  std::string ply = cubePlyBinary(), stl = cubeStlBinary();
  ply.replace(plyHeader("binary_little_endian").size(), 4, nan);
  EXPECT_EQ(read("b.ply", ply).triangles.size(), 6u);
  EXPECT_EQ(report_.nonFiniteFaces, 3u);
  stl.replace(84 + 12, 4, nan);
  EXPECT_EQ(read("b.stl", stl).triangles.size(), 11u);
  EXPECT_EQ(report_.nonFiniteFaces, 1u);
}

TEST_F(MeshFile, RefusesATruncatedFileWithWhatWasReadAndPromised) {
  EXPECT_SAYS(refusal("a.ply", withoutLastLine(cubePlyText())),
              "promises 8 vertices and 6 faces, but ends after 5 of 6 'face'");
  EXPECT_SAYS(refusal("a.off", withoutLastLine(cubeOff())),
              "promises 8 vertices and 6 faces, but ends after 5 faces");
  EXPECT_SAYS(refusal("a.stl", withoutLastLine(cubeStlText())), "endsolid");
  EXPECT_SAYS(refusal("b.stl", cubeStlBinary().substr(0, 400)), "promises 12 facets, but has 6");
  const std::string ply = cubePlyBinary();
  EXPECT_SAYS(refusal("b.ply", ply.substr(0, ply.size() - 1)), "ends after 5 of 6 'face'");
  EXPECT_SAYS(refusal("c.ply", ply.substr(0, plyHeader("binary_little_endian").size() + 30)),
              "ends after 2 of 8 'vertex'");
}

TEST_F(MeshFile, RefusesAPromiseThatTheFileCannotHold) {
  EXPECT_SAYS(refusal("a.ply", replaced(cubePlyText(), "vertex 8", "vertex 4000000000")),
              "truncated");
  EXPECT_SAYS(refusal("b.ply", replaced(cubePlyBinary(), "face 6", "face 4294967295")),
              "truncated");
  EXPECT_SAYS(refusal("c.ply", replaced(cubePlyText(), "vertex 8", "vertex 5000000000")),
              "element vertex 5000000000");
  EXPECT_SAYS(refusal("a.off", replaced(cubeOff(), "8 6 12", "4000000000 6 0")), "truncated");
  EXPECT_SAYS(refusal("b.off", replaced(cubeOff(), "8 6 12", "8 4000000000 0")), "truncated");
  // The length of a face's list.
  EXPECT_SAYS(refusal("d.ply", replaced(cubePlyText(), "7 4 ", "7 4000000000 ")), "truncated");
}

TEST_F(MeshFile, NamesTheFaceThatRefersToAMissingVertex) {
  EXPECT_SAYS(refusal("a.obj", cubeObj() + "f 1 2 9\n"),
              "line 20 has a face that refers to vertex '9'; the file has 8");
  EXPECT_SAYS(refusal("b.obj", cubeObj() + "f 1 2 0\n"), "vertex '0'");
  EXPECT_SAYS(refusal("c.obj", cubeObj() + "f 1 2 -9\n"), "vertex '-9'");
  EXPECT_SAYS(refusal("d.obj", cubeObj() + "f /1 2 3\n"), "vertex ''");
  EXPECT_SAYS(refusal("e.obj", cubeObj() + "f 1//1 2//1 3//1\n"), "normal '1'");
  EXPECT_SAYS(refusal("a.off", replaced(cubeOff(), "4  0 3", "4  0 8")), "vertex '8'");
  EXPECT_SAYS(refusal("a.ply", replaced(cubePlyText(), "7 4 0", "7 4 8")),
              "face (number 0) that refers to vertex 8");
}

TEST_F(MeshFile, RefusesWhatIsNoMesh) {
  EXPECT_SAYS(refusal("a.fbx", cubeObj()), ".obj .ply .off .stl .glb .gltf");
  for (const std::string name : {"a.obj", "a.ply", "a.off", "a.stl"}) {
    refusal(name, "");
    refusal(name, "This is a letter to my aunt.\n");
  }
  EXPECT_SAYS(refusal("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "no face");
  EXPECT_SAYS(refusal("c.obj", "v 0 0\n"), "line 1");
  fs::create_directories(folder_ / "folder.obj");
  EXPECT_THROW(readMeshFile(folder_ / "folder.obj"), Error);
  EXPECT_THROW(readMeshFile(folder_ / "absent.obj"), Error);
}

TEST_F(MeshFile, SetsTheModelOnTheGround) {
  for (const std::string unit : {"1e-30", "1", "25.4", "1e30"}) {
    std::string text;
    for (int i = 0; i < 4; ++i)
      for (const std::string& y : {std::string("0"), unit})
        text += "v " + std::string(i % 2 ? unit : "0") + " " + y + " " +
                std::string(i / 2 ? unit : "0") + "\n";
    const Scene scene = sceneFromMeshFile(put(
        "box.obj", text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 2 6 8 4\nf 1 3 7 5\n"));
    SCOPED_TRACE(unit);
    ASSERT_GE(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].name, "box");
    const Eigen::AlignedBox3d box = scene.objects[0].mesh.bounds();
    EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(-2.0, 0.0, -2.0), 1e-6));
    EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(2.0, 4.0, 2.0), 1e-6));
    EXPECT_GT(scene.camera.position.y(), 0.0);
    EXPECT_TRUE(scene.lightBounds().contains(box));
    EXPECT_NO_THROW(fitLightFrame(scene.light, scene.lightBounds()));
  }
}

}  // namespace
}  // namespace umbra
