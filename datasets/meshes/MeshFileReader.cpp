#include "datasets/meshes/MeshFileReader.h"

#include <algorithm>
#include <limits>

#include "datasets/meshes/MeshFilePolygon.h"
#include "datasets/meshes/MeshFileText.h"
#include "filters/core/support/InputFile.h"

namespace umbra::meshfile {
namespace {

using Eigen::Vector3d;

struct Format {
  const char* extension;
  PolygonMesh (*read)(std::string_view content, const std::string& name, const Progress& progress);
};

constexpr std::array<Format, 6> formats{{{".obj", readObj},
                                         {".ply", readPly},
                                         {".off", readOff},
                                         {".stl", readStl},
                                         {".glb", readGltf},
                                         {".gltf", readGltf}}};

PolygonMesh polygonsOf(std::string_view content, const std::string& extension,
                       const std::string& name, const Progress& progress) {
  for (const Format& format : formats)
    if (extension == format.extension) return format.read(content, name, progress);
  refuse(name, "is no mesh file; those end in " + meshExtensions());
}

// Whether the three positions span an area that single precision can distinguish from none.
bool hasArea(const std::vector<Vector3d>& positions, const Triangle& t) {
  const Vector3d &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() > 1e-7 * longest;
}

class Triangulation {
 public:
  Triangulation(const PolygonMesh& polygons, RawMesh& raw, const Progress& progress)
      : polygons_(polygons), raw_(raw), progress_(progress) {}

  void run() {
    raw_.report.shortFaces = polygons_.shortFaces;
    raw_.report.nonFiniteFaces = polygons_.nonFiniteFaces;
    raw_.triangles.reserve(polygons_.faceCount());
    raw_.triangleParts.reserve(polygons_.faceCount());
    for (std::size_t f = 0; f < polygons_.faceCount(); ++f) {
      progress_.step(f, polygons_.faceCount());
      add(f);
    }
  }

 private:
  void add(std::size_t f) {
    const std::span<const std::uint32_t> face = polygons_.face(f);
    // Values beyond those of a float are damage.
    const auto isFinite = [&](std::uint32_t v) {
      return (raw_.positions[v].array().abs() <= double(std::numeric_limits<float>::max())).all();
    };
    if (!std::all_of(face.begin(), face.end(), isFinite)) {
      ++raw_.report.nonFiniteFaces;
      return;
    }
    const std::size_t before = raw_.triangles.size();
    if (face.size() == 3) {
      keep({face[0], face[1], face[2]}, f);
    } else {
      corners_.clear();
      for (std::uint32_t v : face) corners_.push_back(raw_.positions[v]);
      const Triangulated cut = triangulated(corners_, testsLeft_);
      raw_.report.crossedFaces += cut.crossesItself;
      raw_.report.longFaces += cut.hasTooManyCorners;
      for (const Triangle& t : cut.triangles) keep({face[t[0]], face[t[1]], face[t[2]]}, f);
    }
    raw_.report.degenerateFaces += raw_.triangles.size() == before;
  }

  void keep(const Triangle& t, std::size_t f) {
    if (!hasArea(raw_.positions, t)) return;
    raw_.triangles.push_back(t);
    raw_.triangleParts.push_back(polygons_.faceParts.empty() ? 0 : polygons_.faceParts[f]);
  }

  const PolygonMesh& polygons_;
  RawMesh& raw_;
  const Progress progress_;
  std::vector<Vector3d> corners_;
  std::uint64_t testsLeft_ = manyTests;  // of the whole file
};

}  // namespace

std::string meshExtensions() {
  std::string all;
  for (const Format& format : formats) (all += all.empty() ? "" : " ") += format.extension;
  return all;
}

bool isMeshName(const std::filesystem::path& file) {
  const std::string extension = lowered(file.extension().string());
  return std::any_of(formats.begin(), formats.end(),
                     [&](const Format& format) { return extension == format.extension; });
}

bool mayReferToFiles(const std::filesystem::path& file) {
  const std::string extension = lowered(file.extension().string());
  return extension == ".gltf" || extension == ".glb";
}

RawMesh readMesh(std::string_view content, const std::string& extension, const std::string& name,
                 const Progress& progress) {
  PolygonMesh polygons = polygonsOf(content, extension, name, progress.stage(0.0, 0.8));
  RawMesh raw;
  raw.positions = std::move(polygons.positions);
  raw.parts = polygons.parts;
  raw.materials = polygons.materials;
  raw.report.notes = polygons.notes;
  Triangulation(polygons, raw, progress.stage(0.8, 1.0)).run();
  const MeshReport& report = raw.report;
  if (raw.triangles.empty()) {
    const std::string left = report.summary();
    refuse(name, "has no face that could be shown" + (left.empty() ? "" : ": " + left));
  }
  bool all = !polygons.normals.empty() && !polygons.hasCreases;
  polygons.normals.resize(all ? raw.positions.size() : 0, Eigen::Vector3f::Zero());
  for (const Triangle& t : raw.triangles)
    for (std::uint32_t v : t) all = all && polygons.normals[v].squaredNorm() > 0.0f;
  if (all) raw.normals = std::move(polygons.normals);
  raw.report.normalsComputed = !all;
  return raw;
}

RawMesh readRawMesh(const std::filesystem::path& file, const Progress& progress) {
  return readMesh(contentOf(file, largestMesh), lowered(file.extension().string()), file.string(),
                  progress);
}

}  // namespace umbra::meshfile
