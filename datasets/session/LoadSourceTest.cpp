#include "datasets/session/LoadSource.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

class LoadSource : public testing::Test {
 protected:
  SceneSource meshOf(const std::string& text) {
    std::ofstream(file_) << text;
    SceneSource source;
    source.kind = SourceKind::MeshFile;
    source.name = file_.string();
    return source;
  }
  void TearDown() override { std::filesystem::remove(file_); }

  std::filesystem::path file_ = std::filesystem::path(testing::TempDir()) / "load-source.obj";
};

TEST_F(LoadSource, BuildsAScene) {
  SceneSource source;
  source.name = "two-planes";
  const Content content = loadSource(source);
  ASSERT_TRUE(content.scene);
  EXPECT_FALSE(content.depth);
  EXPECT_EQ(content.scene->name, "two-planes");
  EXPECT_TRUE(content.notices.empty());
}

TEST_F(LoadSource, SaysWhatAMeshLost) {
  const Content content =
      loadSource(meshOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\n"));
  ASSERT_TRUE(content.scene);
  ASSERT_EQ(content.notices.size(), 1u);
  EXPECT_EQ(content.notices[0], file_.string() + ": 1 face without area was left out");
}

TEST_F(LoadSource, SaysNothingOfASoundMesh) {
  EXPECT_TRUE(loadSource(meshOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).notices.empty());
}

TEST_F(LoadSource, RefusesWhatIsNotThere) {
  SceneSource source;
  source.kind = SourceKind::DepthFile;
  source.name = (file_.parent_path() / "absent.exr").string();
  EXPECT_THROW(loadSource(source), Error);
}

}  // namespace
}  // namespace umbra
