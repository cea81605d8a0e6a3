#include "filters/core/maps/ReceiverBias.h"

#include <algorithm>
#include <cmath>

#include "filters/core/maps/MipLevels.h"

namespace umbra {
Eigen::Vector2d depthPerTexel(const LightFrame& light, int mapSize, const Eigen::Vector3d& world,
                              const Eigen::Vector3d& normal) {
  const Eigen::Vector3d n = light.worldToLight.topLeftCorner<3, 3>() * normal;
  // A texel's side: at unit distance before a spot light, anywhere for a directional one.
  const Eigen::Vector2d step(2.0 / (mapSize * std::abs(light.lightToClip(0, 0))),
                             2.0 / (mapSize * std::abs(light.lightToClip(1, 1))));
  Eigen::Vector2d gradient;
  if (light.kind == LightKind::Directional) {
    gradient = n.head<2>() / n.z();
  } else {
    // The distance along a ray q = (x, y, −1) is d(q) = |q| (n·p) / (n·q), derived by x and y.
    const Eigen::Vector3d p = (light.worldToLight * world.homogeneous()).head<3>();
    const Eigen::Vector3d q = p / -p.z();
    const double along = n.dot(q), ray = q.norm();
    gradient = n.dot(p) * (q.head<2>() / (ray * along) - ray * n.head<2>() / (along * along));
  }
  return gradient.cwiseAbs().cwiseProduct(step) / (light.farDistance - light.nearDistance);
}

Eigen::Vector2d readReach(const ReadPoint& read, const FrameSettings& frame, double finer) {
  const double kernel = frame.kernel.effectiveRadius();
  const Eigen::Vector2d size = finer * Eigen::Vector2d(read.footprint.x, read.footprint.y);
  switch (read.filter) {
    case ReadFilter::Point:
      return Eigen::Vector2d::Constant(kernel + 0.5);
    case ReadFilter::Bilinear:
      return Eigen::Vector2d::Constant(kernel + 1.0);
    case ReadFilter::SummedArea:
      return (0.5 * size.cwiseMax(2.0 * kernel + 1.0)).array() + 0.5;
    case ReadFilter::Trilinear:
    case ReadFilter::Anisotropic:
      break;
  }
  const int count = read.footprint.probes;
  const ReadPoint coarse{read.filter, read.u, read.v, {size.x(), size.y(), count}};
  int level = 0;
  for (const LevelRead& each : levelReadsOf(coarse, frame.map.size, frame.map.size))
    level = std::max(level, each.level);
  const double probes = 0.5 - 0.5 / count;
  return (size.cwiseAbs() * probes).array() + kernel + 1.5 * std::ldexp(1.0, level) - 0.5;
}

double biasedReceiver(double z, const Bias& bias, const Eigen::Vector2d& perTexel,
                      const Eigen::Vector2d& reach) {
  Eigen::Vector2d texels = Eigen::Vector2d::Constant(bias.slope);
  if (bias.receiverPlane) texels += reach;
  const double slope = texels.dot(perTexel);
  // Written so that a plane that is edge-on, whose slope is no number, ends at the limit too.
  const double all =
      bias.constant + (slope < ReceiverBias::largest ? slope : ReceiverBias::largest);
  return std::clamp(z - all, 0.0, 1.0);
}

ReceiverBias::ReceiverBias(const LightFrame& light, const FrameSettings& frame)
    : light_(light),
      mapSize_(frame.map.size),
      bias_(frame.bias),
      reach_(readReach({frame.read.filter, 0.0, 0.0, {}}, frame)) {}

double ReceiverBias::receiver(const Eigen::Vector3d& world, const Eigen::Vector3d& normal) const {
  const double z =
      (light_.distance(world) - light_.nearDistance) / (light_.farDistance - light_.nearDistance);
  return biasedReceiver(z, bias_, depthPerTexel(light_, mapSize_, world, normal), reach_);
}

}  // namespace umbra
