#include <numbers>

#include "datasets/scenes/MeshBuilder.h"

namespace umbra::scenes {

void append(Mesh& mesh, const Mesh& other) {
  const std::uint32_t offset = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

Mesh transformed(const Mesh& mesh, const Eigen::Affine3d& transform) {
  Mesh result = mesh;
  const Eigen::Affine3f points = transform.cast<float>();
  const Eigen::Matrix3f normals = transform.linear().inverse().transpose().cast<float>();
  for (Eigen::Vector3f& position : result.positions) position = points * position;
  for (Eigen::Vector3f& normal : result.normals) normal = (normals * normal).normalized();
  return result;
}

Eigen::Affine3d moved(const Vector3d& by) {
  return Eigen::Affine3d(Eigen::Translation3d(by));
}

Eigen::Affine3d turned(double degrees, const Vector3d& axis) {
  return Eigen::Affine3d(Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized()));
}

// SplitMix64: 53 bits of each output become a fraction.
double Random::uniform(double low, double high) {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return low + (high - low) * double(z >> 11) * 0x1p-53;
}

Vector3d Random::direction() {
  const double y = uniform(-1.0, 1.0), angle = uniform(0.0, 2.0 * std::numbers::pi);
  const double ring = std::sqrt(std::max(0.0, 1.0 - y * y));
  return {ring * std::cos(angle), y, ring * std::sin(angle)};
}

}  // namespace umbra::scenes
