#include "ui/picture/Footprint.h"

#include <algorithm>
#include <cmath>

namespace umbra {
namespace {

constexpr int pointsPerSide = 8;  // rays of a spot light meet a plane along straight lines, but at
                                  // one depth along arcs

std::optional<Eigen::Vector3d> nearerOf(const Eigen::Vector3d& point,
                                        const std::vector<std::optional<Eigen::Vector3d>>& others) {
  std::optional<Eigen::Vector3d> best;
  for (const auto& other : others)
    if (other && (!best || (*other - point).norm() < (*best - point).norm())) best = other;
  return best;
}

Eigen::Vector3d onSurface(double u, double v, double z, const LightFrame& frame,
                          const std::optional<Plane>& surface) {
  const Eigen::Vector3d fallback = frame.unproject(u, v, z);
  if (!surface) return fallback;
  const Eigen::Vector3d start = frame.unproject(u, v, 0.0);
  const Eigen::Vector3d way = frame.unproject(u, v, 1.0) - start;
  const double slope = surface->normal().dot(way);
  if (std::abs(slope) < 1e-3 * way.norm()) return fallback;  // the ray grazes the surface
  const double t = -surface->signedDistance(start) / slope;
  return t > 0.0 && t < 1.5 ? Eigen::Vector3d(start + t * way) : fallback;
}

}  // namespace

std::optional<Plane> planeThrough(const Eigen::Vector3d& point,
                                  const std::vector<std::optional<Eigen::Vector3d>>& leftRight,
                                  const std::vector<std::optional<Eigen::Vector3d>>& upDown) {
  const auto across = nearerOf(point, leftRight), along = nearerOf(point, upDown);
  if (!across || !along) return std::nullopt;
  const Eigen::Vector3d a = *across - point, b = *along - point;
  const Eigen::Vector3d normal = a.cross(b);
  if (normal.norm() < 1e-3 * a.norm() * b.norm() || normal.norm() == 0.0) return std::nullopt;
  return Plane(normal.normalized(), point);
}

std::vector<Eigen::Vector3d> footprintOf(const Region& region, int size, double z,
                                         const LightFrame& frame,
                                         const std::optional<Plane>& surface) {
  if (region.texels.empty() || size <= 0) return {};
  int left = size, top = size, right = 0, bottom = 0;  // texels; right and bottom are exclusive
  for (const RegionTexel& texel : region.texels) {
    left = std::min(left, texel.x);
    top = std::min(top, texel.y);
    right = std::max(right, texel.x + 1);
    bottom = std::max(bottom, texel.y + 1);
  }
  const std::array<Eigen::Vector2d, 5> corners{
      Eigen::Vector2d(left, top), Eigen::Vector2d(right, top), Eigen::Vector2d(right, bottom),
      Eigen::Vector2d(left, bottom), Eigen::Vector2d(left, top)};
  std::vector<Eigen::Vector3d> outline;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < pointsPerSide; ++i) {
      const double t = double(i) / pointsPerSide;
      const Eigen::Vector2d texel = (1.0 - t) * corners[side] + t * corners[side + 1];
      outline.push_back(onSurface(texel.x() / size, texel.y() / size, z, frame, surface));
    }
  return outline;
}

}  // namespace umbra
