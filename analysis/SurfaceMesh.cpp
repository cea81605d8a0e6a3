#include "analysis/SurfaceMesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "filters/core/ClosedBody.h"

namespace umbra {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

class Divider {
 public:
  Divider(SurfaceMesh& mesh, const LightFrame& light, int mapSize)
      : mesh_(mesh), light_(light), toClip_(light.worldToClip()), size_(mapSize) {
    for (const Eigen::Vector3f& position : mesh_.positions) addClip(position);
  }

  // Divides until no edge on the map is longer than `edge`. False, and the mesh stays as it is,
  // where that takes more than `most` faces.
  bool divide(double edge, std::size_t most, const std::function<void()>& check) {
    const std::size_t positions = mesh_.positions.size();
    const std::vector<SurfaceFace> before = mesh_.faces;
    while (markEdges(edge)) {
      check();
      if (facesAfterwards() > most) {
        mesh_.positions.resize(positions);
        mesh_.normals.resize(positions);
        clip_.resize(positions);
        mesh_.faces = before;
        return false;
      }
      splitFaces();
    }
    return true;
  }

 private:
  static constexpr std::uint32_t whole = UINT32_MAX;  // an edge that is not halved

  void addClip(const Eigen::Vector3f& position) {
    clip_.push_back(toClip_ * position.cast<double>().homogeneous());
  }

  // In front of a spot light, farther than the place where the map's width becomes none.
  double nearestW() const {
    return light_.kind == LightKind::Spot ? 0.3 * light_.nearDistance : 0.5;
  }

  bool mayLieOnMap(const SurfaceFace& face) const {
    const auto all = [&](auto outside) {
      return std::all_of(face.corners.begin(), face.corners.end(),
                         [&](std::uint32_t corner) { return outside(clip_[corner]); });
    };
    return !all([](const Vector4d& c) { return c.x() < -c.w(); }) &&
           !all([](const Vector4d& c) { return c.x() > c.w(); }) &&
           !all([](const Vector4d& c) { return c.y() < -c.w(); }) &&
           !all([](const Vector4d& c) { return c.y() > c.w(); }) &&
           !all([this](const Vector4d& c) { return c.w() < nearestW(); });
  }

  // Its plane or, where it is shaded as a curved one, a corner.
  bool mayFaceLight(const SurfaceFace& face) const {
    const auto position = [&](int i) {
      return Vector3d(mesh_.positions[face.corners[i]].cast<double>());
    };
    const Vector3d a = position(0);
    const auto turned = [&](const Vector3d& at, const Vector3d& normal) {
      const double cosine = cosineToLight(light_, at, normal);
      return (face.twoSided ? std::abs(cosine) : cosine) > edgeOnCosine;
    };
    if (turned(a, (position(1) - a).cross(position(2) - a))) return true;
    for (int i = 0; i < 3; ++i)
      if (turned(position(i), mesh_.normals[face.corners[i]].cast<double>())) return true;
    return false;
  }

  // On the map, texels, as far as it lies in front of the light.
  double lengthOf(std::uint32_t from, std::uint32_t to) const {
    Vector4d a = clip_[from], b = clip_[to];
    const double least = nearestW();
    if (a.w() < least && b.w() < least) return 0.0;
    if (a.w() < least) a += (b - a) * ((least - a.w()) / (b.w() - a.w()));
    if (b.w() < least) b += (a - b) * ((least - b.w()) / (a.w() - b.w()));
    return 0.5 * size_ * (a.head<2>() / a.w() - b.head<2>() / b.w()).norm();
  }

  static std::uint64_t keyOf(std::uint32_t from, std::uint32_t to) {
    return (std::uint64_t(std::min(from, to)) << 32) | std::max(from, to);
  }

  // The longest edge of each face that has one to be halved. Faces of which another edge is halved
  // get their own longest one halved with it, so that none becomes slender (Rivara 1984).
  bool markEdges(double edge) {
    middles_.clear();
    for (const SurfaceFace& face : mesh_.faces) {
      int longest = 0;
      std::array<double, 3> lengths;
      for (int i = 0; i < 3; ++i) {
        lengths[i] = lengthOf(face.corners[i], face.corners[(i + 1) % 3]);
        if (lengths[i] > lengths[longest]) longest = i;
      }
      if (lengths[longest] > edge && mayLieOnMap(face) && mayFaceLight(face)) mark(face, longest);
    }
    if (middles_.empty()) return false;
    for (bool more = true; more;) {
      more = false;
      for (const SurfaceFace& face : mesh_.faces)
        if (isMarked(face, 0) || isMarked(face, 1) || isMarked(face, 2))
          more = mark(face, longestInWorld(face)) || more;
    }
    return true;
  }

  bool isMarked(const SurfaceFace& face, int i) const {
    return middles_.contains(keyOf(face.corners[i], face.corners[(i + 1) % 3]));
  }

  // False where it was already.
  bool mark(const SurfaceFace& face, int i) {
    return middles_.try_emplace(keyOf(face.corners[i], face.corners[(i + 1) % 3]), whole).second;
  }

  int longestInWorld(const SurfaceFace& face) const {
    const auto squared = [&](int i) {
      return (mesh_.positions[face.corners[i]] - mesh_.positions[face.corners[(i + 1) % 3]])
          .squaredNorm();
    };
    const float lengths[] = {squared(0), squared(1), squared(2)};
    return int(std::max_element(lengths, lengths + 3) - lengths);
  }

  std::size_t facesAfterwards() const {
    std::size_t count = mesh_.faces.size();
    for (const SurfaceFace& face : mesh_.faces)
      for (int i = 0; i < 3; ++i) count += isMarked(face, i);
    return count;
  }

  std::uint32_t middleOf(std::uint32_t from, std::uint32_t to) {
    const auto found = middles_.find(keyOf(from, to));
    if (found == middles_.end()) return whole;
    if (found->second != whole) return found->second;
    found->second = std::uint32_t(mesh_.positions.size());
    mesh_.positions.push_back(0.5f * (mesh_.positions[from] + mesh_.positions[to]));
    const Eigen::Vector3f normal = mesh_.normals[from] + mesh_.normals[to];
    mesh_.normals.push_back(normal.norm() > 0.0f ? Eigen::Vector3f(normal.normalized())
                                                 : mesh_.normals[from]);
    addClip(mesh_.positions.back());
    return found->second;
  }

  void splitFaces() {
    std::vector<SurfaceFace> before;
    before.swap(mesh_.faces);
    mesh_.faces.reserve(2 * before.size());
    for (const SurfaceFace& face : before) split(face);
  }

  void add(SurfaceFace face, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    face.corners = {a, b, c};
    mesh_.faces.push_back(face);
  }

  void split(const SurfaceFace& face) {
    std::array<std::uint32_t, 3> v = face.corners, m{};
    for (int i = 0; i < 3; ++i) m[i] = middleOf(v[i], v[(i + 1) % 3]);
    const auto halved = 3 - std::count(m.begin(), m.end(), whole);
    // Turned so that a single halved edge is the first, and a single whole one the last.
    for (int i = 0; i < 2 && halved < 3 && halved > 0; ++i) {
      if (m[0] != whole && (halved == 1 || m[2] == whole)) break;
      std::rotate(v.begin(), v.begin() + 1, v.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
    if (halved == 0) {
      mesh_.faces.push_back(face);
    } else if (halved == 1) {
      add(face, v[0], m[0], v[2]);
      add(face, m[0], v[1], v[2]);
    } else if (halved == 2) {
      add(face, m[0], v[1], m[1]);
      const auto distance = [&](std::uint32_t a, std::uint32_t b) {
        return (mesh_.positions[a] - mesh_.positions[b]).squaredNorm();
      };
      const bool fromFirst = distance(v[0], m[1]) < distance(m[0], v[2]);
      add(face, v[0], m[0], fromFirst ? m[1] : v[2]);
      add(face, fromFirst ? v[0] : m[0], m[1], v[2]);
    } else {
      for (int i = 0; i < 3; ++i) add(face, v[i], m[i], m[(i + 2) % 3]);
      add(face, m[0], m[1], m[2]);
    }
  }

  SurfaceMesh& mesh_;
  const LightFrame& light_;
  Eigen::Matrix4d toClip_;
  double size_;
  std::vector<Vector4d> clip_;                                // of each position
  std::unordered_map<std::uint64_t, std::uint32_t> middles_;  // by halved edge
};

bool hasArea(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3d a = mesh.positions[triangle[0]].cast<double>();
  const Vector3d b = mesh.positions[triangle[1]].cast<double>();
  const Vector3d c = mesh.positions[triangle[2]].cast<double>();
  return (b - a).cross(c - a).norm() > 0.0;
}

SurfaceMesh trianglesOf(const Scene& scene) {
  SurfaceMesh result;
  for (std::uint32_t object = 0; object < scene.objects.size(); ++object) {
    const Mesh& mesh = scene.objects[object].mesh;
    const auto offset = std::uint32_t(result.positions.size());
    result.positions.insert(result.positions.end(), mesh.positions.begin(), mesh.positions.end());
    result.normals.insert(result.normals.end(), mesh.normals.begin(), mesh.normals.end());
    const std::vector<bool> closed = closedTriangles(mesh);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto [a, b, c] = mesh.triangles[i];
      if (hasArea(mesh, mesh.triangles[i]))
        result.faces.push_back({{a + offset, b + offset, c + offset}, object, !closed[i]});
    }
  }
  return result;
}

}  // namespace

double cosineToLight(const LightFrame& light, const Vector3d& world, const Vector3d& normal) {
  const Vector3d way =
      light.kind == LightKind::Spot ? Vector3d(light.position - world) : Vector3d(-light.direction);
  const double length = way.norm() * normal.norm();
  return length > 0.0 ? way.dot(normal) / length : 0.0;
}

SurfaceMesh surfaceMeshOf(const Scene& scene, const LightFrame& light, int mapSize,
                          const SurfaceMeshSettings& settings, const std::function<void()>& check) {
  SurfaceMesh mesh = trianglesOf(scene);
  check();
  Divider divider(mesh, light, mapSize);
  // From coarse to fine, so that what there is no room for is missing evenly.
  double edge = settings.edge;
  while (edge < mapSize) edge *= 2.0;
  for (mesh.edge = 2.0 * edge; edge >= settings.edge; edge *= 0.5) {
    if (!divider.divide(edge, settings.mostFaces, check)) break;
    mesh.edge = edge;
  }
  return mesh;
}

}  // namespace umbra
