#include "filters/core/maps/ReceiverBias.h"

#include <algorithm>
#include <cmath>

namespace umbra {
namespace {

// How far the centres of the texels that a read averages lie from its position, at most, along
// either axis.
double reachOf(const FrameSettings& frame) {
  return frame.kernel.effectiveRadius() + (frame.read.filter == ReadFilter::Point ? 0.5 : 1.0);
}

}  // namespace

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

ReceiverBias::ReceiverBias(const LightFrame& light, const FrameSettings& frame)
    : light_(light),
      mapSize_(frame.map.size),
      constant_(frame.bias.constant),
      texels_(frame.bias.slope + (frame.bias.receiverPlane ? reachOf(frame) : 0.0)) {}

double ReceiverBias::receiver(const Eigen::Vector3d& world, const Eigen::Vector3d& normal) const {
  const double z =
      (light_.distance(world) - light_.nearDistance) / (light_.farDistance - light_.nearDistance);
  const double slope = texels_ * depthPerTexel(light_, mapSize_, world, normal).sum();
  // Written so that a plane that is edge-on, whose slope is no number, ends at the limit too.
  const double bias = constant_ + (slope < largest ? slope : largest);
  return std::clamp(z - bias, 0.0, 1.0);
}

}  // namespace umbra
