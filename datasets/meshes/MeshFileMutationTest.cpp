// Damaged files: whatever was changed, a reader returns a sound mesh or says what is wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "datasets/meshes/MeshFile.h"
#include "datasets/meshes/MeshFileReader.h"
#include "datasets/meshes/MeshFileSamples.h"
#include "datasets/scenes/MeshBuilder.h"
#include "datasets/scenes/MeshScene.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;
using scenes::Random;

struct Sample {
  std::string name, extension, content;
};

void PrintTo(const Sample& sample, std::ostream* out) {
  *out << sample.name;
}

std::vector<Sample> samples() {
  using namespace meshsamples;
  return {{"obj", ".obj", cubeObj()},
          {"plyText", ".ply", cubePlyText()},
          {"plyLittleEnd", ".ply", cubePlyBinary()},
          {"plyBigEnd", ".ply", cubePlyBinary(true)},
          {"off", ".off", cubeOff()},
          {"stlText", ".stl", cubeStlText()},
          {"stlBinary", ".stl", cubeStlBinary()},
          {"gltf", ".gltf", cubeGltfText()},
          {"glb", ".glb", cubeGlb()}};
}

std::size_t below(Random& random, std::size_t limit) {
  return std::min(limit - 1, std::size_t(random.uniform() * double(limit)));
}

// One or two changes: a byte, a bit, a cut, a piece doubled, removed or replaced by something
// that readers stumble over.
std::string mutated(std::string text, Random& random) {
  const std::string awkward[] = {"nan",        "-1",
                                 "4294967295", "99999999999999999999",
                                 "1e400",      "\xff\xff\xff\xff",
                                 "\0\0\0\0",   " ",
                                 "\n",         "list",
                                 "-",          "/",
                                 "//"};
  for (std::size_t change = 1 + below(random, 2); change > 0 && text.size() > 1; --change) {
    const std::size_t at = below(random, text.size());
    const std::size_t length = 1 + below(random, 12);
    switch (below(random, 6)) {
      case 0:
        text[at] = char(below(random, 256));
        break;
      case 1:
        text[at] = char(text[at] ^ (1 << below(random, 8)));
        break;
      case 2:
        text.resize(at);
        break;
      case 3:
        text.insert(at, text.substr(below(random, text.size()), length));
        break;
      case 4:
        text.erase(at, length);
        break;
      default:
        text.replace(at, length, awkward[below(random, std::size(awkward))]);
    }
  }
  return text;
}

class MeshFileMutation : public testing::TestWithParam<Sample> {
 protected:
  // Returns whether the file was read; a mesh that was read must be sound.
  bool isRead(const std::string& content) {
    std::ofstream(file_, std::ios::binary) << content;
    MeshReport report;
    try {
      const Scene scene = sceneFromMeshFile(file_, UpAxis::Y, &report);
      for (const SceneObject& object : scene.objects) expectSound(object.mesh);
      EXPECT_TRUE(scene.camera.position.allFinite());
      EXPECT_TRUE(scene.light.position.allFinite());
      return true;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      EXPECT_NE(message.find(file_.string()), std::string::npos) << message;
      EXPECT_LT(message.size(), file_.string().size() + 240);
      return false;
    }
  }

  static void expectSound(const Mesh& mesh) {
    ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
    ASSERT_FALSE(mesh.triangles.empty());
    // No mutation makes a file of so few bytes hold more.
    ASSERT_LT(mesh.triangles.size(), 4000u);
    for (const Eigen::Vector3f& position : mesh.positions) ASSERT_TRUE(position.allFinite());
    for (const Eigen::Vector3f& normal : mesh.normals) ASSERT_NEAR(normal.norm(), 1.0f, 1e-5f);
    for (const auto& triangle : mesh.triangles)
      for (std::uint32_t v : triangle) ASSERT_LT(v, mesh.positions.size());
  }

  const TemporaryFolder folder_;
  const fs::path file_ = folder_ / ("mutated" + std::string(GetParam().extension));
};

TEST_P(MeshFileMutation, IsReadSoundlyOrRefused) {
  Random random(20110911);
  int read = 0, refused = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE("mutation " + std::to_string(i));
    (isRead(mutated(GetParam().content, random)) ? read : refused) += 1;
    if (HasFatalFailure()) return;
  }
  // The mutations are neither all harmless nor all fatal.
  EXPECT_GT(read, 0);
  EXPECT_GT(refused, 0);
}

// Many more of them, without a scene around the mesh.
TEST_P(MeshFileMutation, IsReadSoundlyOrRefusedTenThousandTimes) {
  Random random(20261128);
  for (int i = 0; i < 10'000; ++i) {
    SCOPED_TRACE("mutation " + std::to_string(i));
    const std::string content = mutated(GetParam().content, random);
    try {
      const meshfile::RawMesh raw =
          meshfile::readMesh(content, std::string(GetParam().extension), "mutated");
      ASSERT_FALSE(raw.triangles.empty());
      ASSERT_LT(raw.triangles.size(), 4000u);
      ASSERT_EQ(raw.triangles.size(), raw.triangleParts.size());
      for (const auto& triangle : raw.triangles)
        for (std::uint32_t v : triangle) {
          ASSERT_LT(v, raw.positions.size());
          ASSERT_TRUE(raw.positions[v].allFinite());
        }
      for (std::uint32_t part : raw.triangleParts) ASSERT_LT(part, raw.parts.size());
    } catch (const Error& error) {
      ASSERT_EQ(error.kind(), ErrorKind::BadInput);
      ASSERT_TRUE(std::string_view(error.what()).starts_with("mutated: ")) << error.what();
      ASSERT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
    }
  }
}

TEST_P(MeshFileMutation, IsReadSoundlyOrRefusedWhereverItIsCut) {
  const std::string& whole = GetParam().content;
  EXPECT_TRUE(isRead(whole));
  const std::size_t step = 1 + whole.size() / 400;
  for (std::size_t length = 0; length < whole.size(); length += step) {
    SCOPED_TRACE("cut to " + std::to_string(length));
    isRead(whole.substr(0, length));
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFileMutation, testing::ValuesIn(samples()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace umbra
