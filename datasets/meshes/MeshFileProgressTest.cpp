// Who hears how far the reading of a mesh has come may stop it.
#include <gtest/gtest.h>

#include <fstream>

#include "datasets/scenes/MeshScene.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

class MeshFileProgress : public testing::TestWithParam<const char*> {
 protected:
  // A strip of many triangles.
  std::filesystem::path write() const {
    constexpr int columns = 20000;
    const std::string extension = GetParam();
    const std::filesystem::path file = folder_ / ("long" + extension);
    std::ofstream out(file, std::ios::binary);
    if (extension == ".off") out << "OFF\n" << 2 * columns << ' ' << 2 * columns - 2 << " 0\n";
    if (extension == ".ply")
      out << "ply\nformat ascii 1.0\nelement vertex " << 2 * columns
          << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
          << 2 * columns - 2 << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < columns; ++i)
      for (const char* end : {" 0 0\n", " 0 1\n"})
        out << (extension == ".obj" ? "v " : "") << i << end;
    for (int i = 0; i + 2 < 2 * columns; ++i) {
      if (extension == ".obj")
        out << "f " << i + 1 << ' ' << i + 2 << ' ' << i + 3 << '\n';
      else
        out << "3 " << i << ' ' << i + 1 << ' ' << i + 2 << '\n';
    }
    return file;
  }

  const TemporaryFolder folder_;
};

TEST_P(MeshFileProgress, RisesAndCanBeStopped) {
  const std::filesystem::path file = write();
  std::vector<double> parts;
  const Scene scene = sceneFromMeshFile(file, UpAxis::Y, nullptr,
                                        Progress([&](double part) { parts.push_back(part); }));
  EXPECT_GT(scene.triangleCount(), 30000u);
  ASSERT_GE(parts.size(), 6u);
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_GE(parts.front(), 0.0);
  EXPECT_LE(parts.back(), 1.0);
  // Each of the calls can be the one that ends it.
  for (std::size_t last = 0; last < parts.size(); ++last) {
    std::size_t calls = 0;
    const Progress stopping([&](double) {
      if (calls++ == last) throw Error(ErrorKind::Cancelled, "stopped");
    });
    EXPECT_THROW(sceneFromMeshFile(file, UpAxis::Y, nullptr, stopping), Error);
    EXPECT_EQ(calls, last + 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFileProgress, testing::Values(".obj", ".off", ".ply"),
                         [](const auto& one) { return std::string(one.param).substr(1); });

}  // namespace
}  // namespace umbra
