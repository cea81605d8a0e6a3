#include "analysis/surfaces/SurfaceSpot.h"

#include <algorithm>
#include <cmath>

#include "filters/core/scene/ClosedBody.h"

namespace umbra {
namespace {

using Eigen::Vector3d;

// The squared distance of `p` from the triangle (a, b, c), found by the region of its plane over
// which p lies (Ericson 2005, "Real-Time Collision Detection", §5.1.5).
double squaredDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const auto toSegment = [&p](const Vector3d& from, const Vector3d& to) {
    const Vector3d way = to - from;
    const double length = way.squaredNorm();
    const double t = length > 0.0 ? std::clamp((p - from).dot(way) / length, 0.0, 1.0) : 0.0;
    return (p - from - t * way).squaredNorm();
  };
  const Vector3d normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  const bool inside = area > 0.0 && normal.dot((b - a).cross(p - a)) >= 0.0 &&
                      normal.dot((c - b).cross(p - b)) >= 0.0 &&
                      normal.dot((a - c).cross(p - c)) >= 0.0;
  if (inside) {
    const double height = normal.dot(p - a);
    return height * height / area;
  }
  return std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

}  // namespace

std::optional<SurfaceSpot> surfaceNear(const Scene& scene, const Vector3d& point) {
  const Eigen::AlignedBox3d bounds = scene.lightBounds();
  double nearest = 1e-3 * (bounds.diagonal().norm() + (point - bounds.center()).norm());
  std::optional<SurfaceSpot> spot;
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Mesh& mesh = scene.objects[i].mesh;
    for (std::size_t j = 0; j < mesh.triangles.size(); ++j) {
      const auto& corners = mesh.triangles[j];
      const Vector3d a = mesh.positions[corners[0]].cast<double>();
      const Vector3d b = mesh.positions[corners[1]].cast<double>();
      const Vector3d c = mesh.positions[corners[2]].cast<double>();
      const Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
      const double outside = (low - point).cwiseMax(point - high).maxCoeff();
      if (outside >= nearest) continue;
      const double distance = std::sqrt(squaredDistance(point, a, b, c));
      const Vector3d across = (b - a).cross(c - a);
      if (distance >= nearest || across.squaredNorm() == 0.0) continue;
      nearest = distance;
      const Vector3d normal = across.normalized();
      spot = SurfaceSpot{point - normal.dot(point - a) * normal, normal, i};
      triangle = j;
    }
  }
  if (spot) spot->twoSided = !closedTriangles(scene.objects[spot->object].mesh)[triangle];
  return spot;
}

}  // namespace umbra
