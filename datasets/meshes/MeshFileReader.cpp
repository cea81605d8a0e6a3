#include "datasets/meshes/MeshFileReader.h"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>
#include <map>
#include <mutex>
#include <sstream>

#include "datasets/meshes/MeshFileImporter.h"
#include "datasets/meshes/MeshFilePolygon.h"
#include "datasets/meshes/MeshFileText.h"
#include "datasets/meshes/MeshNormals.h"

namespace umbra::meshfile {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

// OpenMesh writes to the terminal; a problem is reported once instead, as an Error.
class Silence {
 public:
  Silence() {
    for (OpenMesh::mostream* stream : {&omlog(), &omout(), &omerr()}) stream->disable();
  }
  ~Silence() {
    for (OpenMesh::mostream* stream : {&omlog(), &omout(), &omerr()}) stream->enable();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
};

CheckedMesh checkedMesh(const std::string& content, const std::string& extension,
                        const std::string& name) {
  if (extension == ".obj") return checkObj(content, name);
  if (extension == ".ply") return checkPly(content, name);
  if (extension == ".off") return checkOff(content, name);
  if (extension == ".stl") return checkStl(content, name);
  refuse(name, "is no mesh file; those end in .obj, .ply, .off or .stl");
}

void import(const CheckedMesh& checked, const std::string& extension, const std::string& name,
            Importer& importer) {
  // OpenMesh's readers are singletons that keep a file's header between two calls.
  static std::mutex oneAtATime;
  const std::lock_guard lock(oneAtATime);
  const Silence silence;
  OpenMesh::IO::Options options(OpenMesh::IO::Options::VertexNormal);
  if (checked.binary) options += OpenMesh::IO::Options::Binary;
  std::istringstream stream(checked.content);
  const bool read = OpenMesh::IO::IOManager().read(stream, extension, importer, options);
  // STL's reader shares equal vertices and leaves out facets without area.
  const bool whole = extension == ".stl" ? importer.faces.size() <= checked.faces
                                         : importer.positions.size() == checked.vertices &&
                                               importer.faces.size() == checked.faces;
  if (!read || !whole)
    refuse(name, "cannot be read as " + extension.substr(1) + ": " +
                     std::to_string(importer.positions.size()) + " vertices and " +
                     std::to_string(importer.faces.size()) + " faces were read of " +
                     std::to_string(checked.vertices) + " and " + std::to_string(checked.faces));
}

// Whether the three positions span an area that single precision can distinguish from none.
bool hasArea(const std::vector<Eigen::Vector3f>& positions, const Triangle& t) {
  const Eigen::Vector3d a = positions[t[0]].cast<double>(), b = positions[t[1]].cast<double>(),
                        c = positions[t[2]].cast<double>();
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() > 1e-7 * longest;
}

class Triangulation {
 public:
  Triangulation(const Importer& importer, const CheckedMesh& checked, const std::string& name)
      : importer_(importer), checked_(checked), name_(name), usable_(importer.positions.size()) {
    for (std::size_t v = 0; v < usable_.size(); ++v) usable_[v] = importer.positions[v].allFinite();
    for (std::uint32_t v : checked.nonFinite) usable_.at(v) = false;
  }

  void run(RawMesh& raw) {
    raw.report.degenerateFaces =
        checked_.degenerateFaces + (checked_.faces - importer_.faces.size());
    raw.report.nonFiniteFaces = checked_.nonFiniteFaces;
    for (std::size_t f = 0; f < importer_.faces.size(); ++f) add(f, raw);
  }

 private:
  void add(std::size_t f, RawMesh& raw) const {
    const std::vector<std::int32_t>& face = importer_.faces[f];
    bool finite = true;
    for (std::int32_t v : face) {
      if (v < 0 || std::size_t(v) >= usable_.size())
        refuse(name_, "has a face (number " + std::to_string(f) + ") that refers to vertex " +
                          std::to_string(v) + "; the file has " + std::to_string(usable_.size()) +
                          ", counted from 0");
      finite = finite && usable_[std::size_t(v)];
    }
    if (!finite) {
      ++raw.report.nonFiniteFaces;
      return;
    }
    bool any = false;
    std::vector<Eigen::Vector3d> corners;
    for (std::int32_t v : face) corners.push_back(raw.positions[std::size_t(v)].cast<double>());
    for (const Triangle& cut : triangulated(corners)) {
      const Triangle t{std::uint32_t(face[cut[0]]), std::uint32_t(face[cut[1]]),
                       std::uint32_t(face[cut[2]])};
      if (!hasArea(raw.positions, t)) continue;
      any = true;
      raw.triangles.push_back(t);
      raw.triangleMaterials.push_back(checked_.faceMaterials.empty() ? 0
                                                                     : checked_.faceMaterials[f]);
    }
    raw.report.degenerateFaces += !any;
  }

  const Importer& importer_;
  const CheckedMesh& checked_;
  const std::string& name_;
  std::vector<bool> usable_;
};

}  // namespace

RawMesh readMesh(const std::string& content, const std::string& extension,
                 const std::string& name) {
  const CheckedMesh checked = checkedMesh(content, extension, name);
  Importer importer;
  import(checked, extension, name, importer);
  RawMesh raw;
  raw.positions = importer.positions;
  // The position stays, so that indices do not change; no triangle refers to it.
  for (Eigen::Vector3f& position : raw.positions)
    if (!position.allFinite()) position.setZero();
  raw.materials = checked.materials.empty() ? std::vector<std::string>{""} : checked.materials;
  Triangulation(importer, checked, name).run(raw);
  if (raw.triangles.empty())
    refuse(name, "has no face that could be shown (" + std::to_string(raw.report.degenerateFaces) +
                     " without area, " + std::to_string(raw.report.nonFiniteFaces) +
                     " not finite)");
  bool all = importer.hasNormals && !importer.hasCreases;
  for (const Triangle& t : raw.triangles)
    for (std::uint32_t v : t) all = all && importer.normals[v].norm() > 0.0f;
  if (all) raw.normals = importer.normals;
  raw.report.normalsComputed = !all;
  return raw;
}

namespace {

// Keeps only the vertices that triangles use, in the order of their first use.
Mesh compacted(const RawMesh& raw) {
  Mesh mesh;
  std::vector<std::uint32_t> place(raw.positions.size(), UINT32_MAX);
  for (const Triangle& t : raw.triangles) {
    Triangle moved{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& to = place[t[i]];
      if (to == UINT32_MAX) {
        to = std::uint32_t(mesh.positions.size());
        mesh.positions.push_back(raw.positions[t[i]]);
        mesh.normals.push_back(raw.normals[t[i]]);
      }
      moved[i] = to;
    }
    mesh.triangles.push_back(moved);
  }
  return mesh;
}

}  // namespace

Mesh withItsNormals(const RawMesh& raw) {
  if (!raw.normals.empty()) return compacted(raw);
  std::map<std::array<float, 3>, std::uint32_t> first;
  std::vector<Triangle> welded = raw.triangles;
  for (Triangle& t : welded)
    for (std::uint32_t& v : t) {
      const Eigen::Vector3f& p = raw.positions[v];
      v = first.try_emplace({p.x(), p.y(), p.z()}, v).first->second;
    }
  return withNormals(raw.positions, welded);
}

}  // namespace umbra::meshfile
