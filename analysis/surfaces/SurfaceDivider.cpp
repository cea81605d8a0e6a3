#include "analysis/surfaces/SurfaceDivider.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace umbra {

using Eigen::Vector3d;
using Eigen::Vector4d;

SurfaceDivider::SurfaceDivider(SurfaceMesh& mesh, const LightFrame& light, int mapSize)
    : mesh_(mesh), light_(light), toClip_(light.worldToClip()), size_(mapSize) {
  for (const Eigen::Vector3f& position : mesh_.positions) addClip(position);
  numberEdges();
}

void SurfaceDivider::numberEdges() {
  std::unordered_map<std::uint64_t, std::uint32_t> numbers;
  for (const SurfaceFace& face : mesh_.faces) {
    Corners& edges = edgesOf_.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = face.corners[i], to = face.corners[(i + 1) % 3];
      const std::uint64_t key = (std::uint64_t(std::min(from, to)) << 32) | std::max(from, to);
      const auto [found, added] = numbers.try_emplace(key, 0);
      if (added) found->second = addEdge(from, to);
      edges[i] = found->second;
    }
  }
}

std::uint32_t SurfaceDivider::addEdge(std::uint32_t from, std::uint32_t to) {
  Edge edge;
  edge.first = from;
  edge.length = float(lengthOf(from, to));
  edges_.push_back(edge);
  return std::uint32_t(edges_.size() - 1);
}

void SurfaceDivider::addClip(const Eigen::Vector3f& position) {
  clip_.push_back(toClip_ * position.cast<double>().homogeneous());
}

// The part of an edge in front of a spot light, farther away than the place where the map's width
// becomes 0.
double SurfaceDivider::nearestW() const {
  return light_.kind == LightKind::Spot ? 0.3 * light_.nearDistance : 0.5;
}

// The edge is cut to the part that lies in front of the light.
double SurfaceDivider::lengthOf(std::uint32_t from, std::uint32_t to) const {
  Vector4d a = clip_[from], b = clip_[to];
  const double least = nearestW();
  if (a.w() < least && b.w() < least) return 0.0;
  if (a.w() < least) a += (b - a) * ((least - a.w()) / (b.w() - a.w()));
  if (b.w() < least) b += (a - b) * ((least - b.w()) / (a.w() - b.w()));
  return 0.5 * size_ * (a.head<2>() / a.w() - b.head<2>() / b.w()).norm();
}

bool SurfaceDivider::mayLieOnMap(const SurfaceFace& face) const {
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

// Whether its plane or, where it is shaded as a curved surface, a corner may face the light.
bool SurfaceDivider::mayFaceLight(const SurfaceFace& face) const {
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

std::uint32_t SurfaceDivider::longestOnMap(const Corners& edges) const {
  return std::ranges::max(edges, {}, [this](std::uint32_t e) { return edges_[e].length; });
}

double SurfaceDivider::longestEdge() const {
  double longest = 0.0;
  for (std::size_t i = 0; i < edgesOf_.size(); ++i) {
    const double length = edges_[longestOnMap(edgesOf_[i])].length;
    if (length > longest && mayLieOnMap(mesh_.faces[i]) && mayFaceLight(mesh_.faces[i]))
      longest = length;
  }
  return longest;
}

int SurfaceDivider::longestInWorld(const Corners& corners) const {
  const auto squared = [&](int i) {
    return (mesh_.positions[corners[i]] - mesh_.positions[corners[(i + 1) % 3]]).squaredNorm();
  };
  const float lengths[] = {squared(0), squared(1), squared(2)};
  return int(std::max_element(lengths, lengths + 3) - lengths);
}

// Finds the longest edge of each face that has an edge to be halved. A face of which another edge
// is halved has its own longest edge halved as well, so that no face becomes slender (Rivara 1984).
bool SurfaceDivider::markEdges(double edge) {
  bool any = false;
  for (std::size_t i = 0; i < edgesOf_.size(); ++i) {
    const std::uint32_t longest = longestOnMap(edgesOf_[i]);
    if (double(edges_[longest].length) <= edge || !mayLieOnMap(mesh_.faces[i]) ||
        !mayFaceLight(mesh_.faces[i]))
      continue;
    any = edges_[longest].marked = true;
  }
  for (bool more = any; more;) {
    more = false;
    for (std::size_t i = 0; i < edgesOf_.size(); ++i) {
      const auto marked = [this](std::uint32_t e) { return edges_[e].marked; };
      if (std::ranges::none_of(edgesOf_[i], marked)) continue;
      Edge& longest = edges_[edgesOf_[i][std::size_t(longestInWorld(mesh_.faces[i].corners))]];
      more = more || !longest.marked;
      longest.marked = true;
    }
  }
  return any;
}

std::size_t SurfaceDivider::facesAfterwards() const {
  std::size_t count = mesh_.faces.size();
  for (const Corners& edges : edgesOf_)
    for (std::uint32_t edge : edges) count += edges_[edge].marked;
  return count;
}

bool SurfaceDivider::divide(double edge, std::size_t most, const std::function<void()>& check) {
  const std::size_t positions = mesh_.positions.size(), edgeCount = edges_.size();
  const std::vector<SurfaceFace> faces = mesh_.faces;
  const std::vector<Corners> edgesOf = edgesOf_;
  while (markEdges(edge)) {
    check();
    if (facesAfterwards() > most) {
      mesh_.positions.resize(positions);
      mesh_.normals.resize(positions);
      clip_.resize(positions);
      edges_.resize(edgeCount);
      for (Edge& each : edges_) {
        each.middle = none;
        each.marked = false;
      }
      mesh_.faces = faces;
      edgesOf_ = edgesOf;
      return false;
    }
    splitFaces();
  }
  return true;
}

void SurfaceDivider::halve(std::uint32_t edge, std::uint32_t from, std::uint32_t to) {
  if (!edges_[edge].marked || edges_[edge].middle != none) return;
  const auto middle = std::uint32_t(mesh_.positions.size());
  mesh_.positions.push_back(0.5f * (mesh_.positions[from] + mesh_.positions[to]));
  const Eigen::Vector3f normal = mesh_.normals[from] + mesh_.normals[to];
  mesh_.normals.push_back(normal.norm() > 0.0f ? Eigen::Vector3f(normal.normalized())
                                               : mesh_.normals[from]);
  addClip(mesh_.positions.back());
  const std::uint32_t near = addEdge(from, middle), far = addEdge(middle, to);
  edges_[edge].first = from;
  edges_[edge].middle = middle;
  edges_[edge].halves[0] = near;
  edges_[edge].halves[1] = far;
}

std::uint32_t SurfaceDivider::halfAt(std::uint32_t edge, std::uint32_t end) const {
  return edges_[edge].halves[edges_[edge].first == end ? 0 : 1];
}

void SurfaceDivider::splitFaces() {
  std::vector<SurfaceFace> faces;
  std::vector<Corners> edgesOf;
  faces.swap(mesh_.faces);
  edgesOf.swap(edgesOf_);
  mesh_.faces.reserve(2 * faces.size());
  edgesOf_.reserve(2 * faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) split(faces[i], edgesOf[i]);
}

void SurfaceDivider::add(const SurfaceFace& parent, const Corners& corners, const Corners& edges) {
  mesh_.faces.push_back(parent);
  mesh_.faces.back().corners = corners;
  edgesOf_.push_back(edges);
}

void SurfaceDivider::split(const SurfaceFace& face, Corners e) {
  Corners v = face.corners, m{};
  for (int i = 0; i < 3; ++i) {
    halve(e[i], v[i], v[(i + 1) % 3]);
    m[i] = edges_[e[i]].middle;
  }
  const auto halved = 3 - std::count(m.begin(), m.end(), none);
  // The corners are turned so that a single halved edge is the first, and a single whole one the
  // last.
  while (halved > 0 && halved < 3 && !(m[0] != none && m[2] == none)) {
    std::rotate(v.begin(), v.begin() + 1, v.end());
    std::rotate(e.begin(), e.begin() + 1, e.end());
    std::rotate(m.begin(), m.begin() + 1, m.end());
  }
  if (halved == 0) {
    add(face, v, e);
  } else if (halved == 1) {
    const std::uint32_t cut = addEdge(m[0], v[2]);
    add(face, {v[0], m[0], v[2]}, {halfAt(e[0], v[0]), cut, e[2]});
    add(face, {m[0], v[1], v[2]}, {halfAt(e[0], v[1]), e[1], cut});
  } else if (halved == 2) {
    const std::uint32_t tip = addEdge(m[0], m[1]);
    add(face, {m[0], v[1], m[1]}, {halfAt(e[0], v[1]), halfAt(e[1], v[1]), tip});
    const auto distance = [&](std::uint32_t a, std::uint32_t b) {
      return (mesh_.positions[a] - mesh_.positions[b]).squaredNorm();
    };
    if (distance(v[0], m[1]) < distance(m[0], v[2])) {
      const std::uint32_t cut = addEdge(v[0], m[1]);
      add(face, {v[0], m[0], m[1]}, {halfAt(e[0], v[0]), tip, cut});
      add(face, {v[0], m[1], v[2]}, {cut, halfAt(e[1], v[2]), e[2]});
    } else {
      const std::uint32_t cut = addEdge(m[0], v[2]);
      add(face, {v[0], m[0], v[2]}, {halfAt(e[0], v[0]), cut, e[2]});
      add(face, {m[0], m[1], v[2]}, {tip, halfAt(e[1], v[2]), cut});
    }
  } else {
    Corners cuts{};
    for (int i = 0; i < 3; ++i) cuts[i] = addEdge(m[i], m[(i + 2) % 3]);
    for (int i = 0; i < 3; ++i)
      add(face, {v[i], m[i], m[(i + 2) % 3]},
          {halfAt(e[i], v[i]), cuts[i], halfAt(e[(i + 2) % 3], v[i])});
    add(face, m, {cuts[1], cuts[2], cuts[0]});
  }
}

}  // namespace umbra
