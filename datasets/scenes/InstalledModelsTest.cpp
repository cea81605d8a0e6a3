#include "datasets/scenes/InstalledModels.h"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "datasets/meshes/MaterialFile.h"
#include "datasets/meshes/MeshFileSamples.h"
#include "datasets/scenes/ArchiveFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

void writeZip(const fs::path& file, const std::map<std::string, std::string>& entries) {
  archive* writer = archive_write_new();
  archive_write_set_format_zip(writer);
  ASSERT_EQ(archive_write_open_filename(writer, file.c_str()), ARCHIVE_OK);
  for (const auto& [name, content] : entries) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_size(entry, la_int64_t(content.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    ASSERT_EQ(archive_write_header(writer, entry), ARCHIVE_OK);
    ASSERT_EQ(archive_write_data(writer, content.data(), content.size()),
              la_ssize_t(content.size()));
    archive_entry_free(entry);
  }
  ASSERT_EQ(archive_write_free(writer), ARCHIVE_OK);
}

class InstalledModels : public testing::Test {
 protected:
  std::string refusal(const std::string& name) const {
    try {
      makeInstalledModel(name, folder_);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      return error.what();
    }
    ADD_FAILURE() << name << " was opened";
    return "";
  }
  fs::path collection() const { return folder_ / "BlendSwap-CC-0.sh3f"; }

  const TemporaryFolder temporary_;
  const fs::path& folder_ = temporary_.path();
};

TEST_F(InstalledModels, SayWhichPackageIsMissing) {
  const std::string advice = "install the Debian package sweethome3d-furniture";
  const std::vector<SceneInfo> infos = installedModelInfos(folder_);
  ASSERT_GE(infos.size(), 5u);
  for (const SceneInfo& info : infos) {
    EXPECT_EQ(info.missing, advice);
    EXPECT_EQ(refusal(info.name), "scene " + info.name + ": " + advice);
  }
}

TEST_F(InstalledModels, HaveATitleAndTwoLinesEach) {
  for (const SceneInfo& info : installedModelInfos(folder_)) {
    EXPECT_TRUE(isInstalledModel(info.name));
    EXPECT_FALSE(info.title.empty());
    EXPECT_EQ(std::count(info.description.begin(), info.description.end(), '\n'), 1) << info.name;
  }
  EXPECT_FALSE(isInstalledModel("tree-bench"));
  EXPECT_NE(refusal("zeppelin").find("zeppelin"), std::string::npos);
}

TEST_F(InstalledModels, AreReadWithTheColoursOfTheirMaterials) {
  std::string obj = meshsamples::cubeObj();
  obj.insert(obj.rfind("f "), "usemtl red\n");
  writeZip(collection(),
           {{"blendswap-cc-0/fence/fence.obj", obj},
            {"blendswap-cc-0/fence/fence.mtl",
             "newmtl red\nKd 0.8 0.1 2\nKd broken\n\nnewmtl grey\nNs 9\nKd 0.5 0.5 0.5\n"}});
  EXPECT_EQ(installedModelInfos(folder_)[1].missing, "");
  const Scene scene = makeInstalledModel("iron-fence", folder_);
  EXPECT_EQ(scene.name, "iron-fence");
  ASSERT_GE(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[0].name, "grey");
  EXPECT_EQ(scene.objects[0].mesh.triangles.size(), 10u);
  EXPECT_EQ(scene.objects[0].material.shininess, 9.0);
  EXPECT_EQ(scene.objects[1].name, "red");
  EXPECT_EQ(scene.objects[1].mesh.triangles.size(), 2u);
  // The colours are lifted, but the order of the channels stays, and a full channel stays full.
  const Eigen::Vector3d red = scene.objects[1].material.colour;
  EXPECT_DOUBLE_EQ(red.z(), 1.0);
  EXPECT_GT(red.x(), 0.8);
  EXPECT_GT(red.x(), red.y());
  EXPECT_GT(red.y(), 0.1);
}

TEST_F(InstalledModels, SayWhatIsWrongWithTheCollection) {
  std::ofstream(collection()) << "this is no archive";
  EXPECT_NE(refusal("truck").find(collection().string()), std::string::npos);
  writeZip(collection(), {{"blendswap-cc-0/fence/fence.obj", "v 0 0 0\nf 1 2 3\n"},
                          {"blendswap-cc-0/fence/fence.mtl", ""}});
  EXPECT_NE(refusal("truck").find("no entry 'blendswap-cc-0/peterbilt/peterbilt.obj'"),
            std::string::npos);
  EXPECT_NE(refusal("iron-fence").find("fence.obj: line 2"), std::string::npos);
}

TEST_F(InstalledModels, RefuseADamagedArchive) {
  writeZip(collection(), {{"blendswap-cc-0/fence/fence.obj", meshsamples::cubeObj()},
                          {"blendswap-cc-0/fence/fence.mtl", "newmtl grey\n"}});
  fs::resize_file(collection(), 120);
  EXPECT_NE(refusal("iron-fence").find(collection().string()), std::string::npos);
}

// This reads the package itself, which the tests' list of packages installs.
TEST(InstalledPackage, BringsEveryModel) {
  for (const SceneInfo& info : installedModelInfos()) {
    SCOPED_TRACE(info.name);
    ASSERT_EQ(info.missing, "");
    const Scene scene = makeInstalledModel(info.name);
    EXPECT_EQ(scene.title, info.title);
    EXPECT_GT(scene.triangleCount(), 5000u);
    Eigen::AlignedBox3d model;
    for (const SceneObject& object : scene.objects) {
      EXPECT_FALSE(object.name.empty());
      ASSERT_EQ(object.mesh.positions.size(), object.mesh.normals.size());
      for (const Eigen::Vector3f& normal : object.mesh.normals)
        ASSERT_NEAR(normal.norm(), 1.0f, 1e-5f);
      if (object.name != "ground" && object.name != "paving") model.extend(object.mesh.bounds());
    }
    EXPECT_NEAR(model.min().y(), 0.0, 1e-5);
    EXPECT_GE(model.sizes().maxCoeff(), 3.9);
    EXPECT_TRUE(scene.lightBounds().contains(model));
  }
}

TEST(MaterialFile, SkipsWhatItDoesNotKnow) {
  const auto materials = materialsFrom(
      "Kd 1 1 1\n# a comment\nnewmtl a\r\nKd nan 0 0\nmap_Kd wood.png\nillum 2\nnewmtl b\nKd 0.25 "
      "0.5 "
      "0.75\r\nKs 1 1 1\n");
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_EQ(materials.at("a").colour, Material().colour);
  EXPECT_EQ(materials.at("b").colour, Eigen::Vector3d(0.25, 0.5, 0.75));
  EXPECT_DOUBLE_EQ(materials.at("b").specular, 0.3);
}

}  // namespace
}  // namespace umbra
