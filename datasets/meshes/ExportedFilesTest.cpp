// Files that real programs wrote, as Debian packages ship them, read by this program and by the
// Open Asset Import Library: both must find the same shape. The tests' list of packages installs
// them.
#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <functional>
#include <map>

#include "datasets/meshes/MeshFileReader.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

const fs::path furniture = "/usr/share/sweethome3d/furniture";
const fs::path models = "/usr/share/assimp/models";

struct Shape {
  std::size_t triangles = 0;
  double area = 0.0;
  Eigen::AlignedBox3d bounds;

  void add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    ++triangles;
    area += 0.5 * (b - a).cross(c - a).norm();
    for (const Vector3d& corner : {a, b, c}) bounds.extend(corner);
  }
};

Shape shapeOf(const meshfile::RawMesh& raw) {
  Shape shape;
  for (const auto& t : raw.triangles)
    shape.add(raw.positions[t[0]], raw.positions[t[1]], raw.positions[t[2]]);
  return shape;
}

// The second reader. Nothing where it refuses.
class SecondReader {
 public:
  SecondReader() {
    importer_.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                 aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  }
  Shape file(const fs::path& file) { return shape(importer_.ReadFile(file.string(), steps)); }
  Shape content(const std::string& content, const char* extension) {
    return shape(importer_.ReadFileFromMemory(content.data(), content.size(), steps, extension));
  }

 private:
  static constexpr unsigned steps =
      aiProcess_Triangulate | aiProcess_PreTransformVertices | aiProcess_SortByPType;

  static Vector3d point(const aiMesh& mesh, unsigned vertex) {
    const aiVector3D& p = mesh.mVertices[vertex];
    return {p.x, p.y, p.z};
  }

  static Shape shape(const aiScene* scene) {
    Shape shape;
    for (unsigned m = 0; scene && m < scene->mNumMeshes; ++m)
      for (unsigned f = 0; f < scene->mMeshes[m]->mNumFaces; ++f) {
        const aiMesh& mesh = *scene->mMeshes[m];
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) continue;
        const Vector3d a = point(mesh, face.mIndices[0]), b = point(mesh, face.mIndices[1]),
                       c = point(mesh, face.mIndices[2]);
        if ((b - a).cross(c - a).norm() > 0.0) shape.add(a, b, c);
      }
    return shape;
  }

  Assimp::Importer importer_;
};

// Floats are what the second reader stores. Faces that are not flat have another area when they
// are cut along another diagonal.
void expectSame(const Shape& ours, const Shape& theirs) {
  const double size = theirs.bounds.sizes().norm();
  EXPECT_LT((ours.bounds.min() - theirs.bounds.min()).norm(), 1e-5 * size);
  EXPECT_LT((ours.bounds.max() - theirs.bounds.max()).norm(), 1e-5 * size);
  EXPECT_NEAR(ours.area, theirs.area, 0.02 * theirs.area);
}

// Where the two differ, and why this reader is right.
const std::map<std::string, std::string> refusedHere{
    {"glTF/BoxTextured-glTF/BoxTextured.gltf", "version 1.0"},
    {"glTF/BoxTextured-glTF-Embedded/BoxTextured.gltf", "version 1.0"},
    {"glTF/BoxTextured-glTF-MaterialsCommon/BoxTextured.gltf", "version 1.0"},
    {"glTF/CesiumMilkTruck/CesiumMilkTruck.gltf", "no asset.version"},
    {"glTF/IncorrectVertexArrays/Cube_v1.gltf", "version 1.0"},
    {"glTF/TwoBoxes/TwoBoxes.gltf", "version 1.0"},
    {"glTF2/IndexOutOfRange/IndexOutOfRange.gltf", "vertex 255; its mesh has 24"},
    {"glTF2/draco/2CylinderEngine.gltf", "KHR_draco_mesh_compression"}};
// Files that the second reader finds empty or refuses, with their triangles: one is UTF-16, the
// others have something wrong in names, materials or textures, on which no shape depends.
const std::map<std::string, std::size_t> onlyOurs{{"OBJ/box_UTF16BE.obj", 12},
                                                  {"glTF2/wrongTypes/badExtension.gltf", 12},
                                                  {"glTF2/wrongTypes/badNumber.gltf", 12},
                                                  {"glTF2/wrongTypes/badObject.gltf", 12},
                                                  {"glTF2/wrongTypes/badString.gltf", 12},
                                                  {"glTF2/wrongTypes/badUint.gltf", 12},
                                                  {"glTF2/issue_3269/texcoord_crash.gltf", 10}};
// A file that the second reader gives all memory to.
const std::string tooMuchForThem = "invalid/OutOfMemory.off";

TEST(ExportedFiles, OfManyProgramsGiveWhatASecondReaderFinds) {
  std::size_t same = 0, refusedByBoth = 0, refusedByUs = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(models)) {
    const std::string name = entry.path().lexically_relative(models).string();
    if (!meshfile::isMeshName(entry.path()) || name == tooMuchForThem) continue;
    SCOPED_TRACE(name);
    const Shape theirs = SecondReader().file(entry.path());
    try {
      const Shape ours = shapeOf(meshfile::readRawMesh(entry.path()));
      const auto known = onlyOurs.find(name);
      if (known != onlyOurs.end())
        EXPECT_EQ(ours.triangles, known->second);
      else
        expectSame(ours, theirs);
      ++same;
    } catch (const Error& error) {
      const auto reason = refusedHere.find(name);
      if (reason == refusedHere.end()) {
        EXPECT_EQ(theirs.triangles, 0u) << error.what();
        ++refusedByBoth;
      } else {
        EXPECT_NE(std::string(error.what()).find(reason->second), std::string::npos)
            << error.what();
        ++refusedByUs;
      }
    }
  }
  EXPECT_GE(same, 55u);
  EXPECT_GE(refusedByBoth, 10u);
  EXPECT_EQ(refusedByUs, refusedHere.size());
}

// Every OBJ file in an archive.
void visitObj(
    const fs::path& file,
    const std::function<void(const std::string& name, const std::string& content)>& visit) {
  archive* reader = archive_read_new();
  archive_read_support_format_zip(reader);
  ASSERT_EQ(archive_read_open_filename(reader, file.c_str(), 1 << 16), ARCHIVE_OK);
  archive_entry* entry = nullptr;
  while (archive_read_next_header(reader, &entry) == ARCHIVE_OK) {
    const std::string name = archive_entry_pathname(entry);
    if (!name.ends_with(".obj")) continue;
    std::string content(std::size_t(archive_entry_size(entry)), '\0');
    ASSERT_EQ(archive_read_data(reader, content.data(), content.size()),
              la_ssize_t(content.size()));
    visit(name, content);
  }
  archive_read_free(reader);
}

TEST(ExportedFiles, OfTheFurnitureCollectionsGiveWhatASecondReaderFinds) {
  std::size_t read = 0, seen = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(furniture)) {
    if (entry.path().extension() != ".sh3f") continue;
    visitObj(entry.path(), [&](const std::string& name, const std::string& content) {
      if (seen++ % 6 != 0) return;  // all 820 take ten seconds, and were read once
      SCOPED_TRACE(name);
      expectSame(shapeOf(meshfile::readMesh(content, ".obj", name)),
                 SecondReader().content(content, "obj"));
      ++read;
    });
  }
  EXPECT_GE(read, 100u);
}

}  // namespace
}  // namespace umbra
