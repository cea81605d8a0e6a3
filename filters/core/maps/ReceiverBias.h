// The depth that a surface is compared with: its own, lowered as the shaded frame lowers it.
#pragma once

#include <Eigen/Core>

#include "filters/core/scene/Light.h"
#include "filters/core/settings/FrameSettings.h"

namespace umbra {

// How much the normalised depth of the plane through `world` with this normal (of any length,
// either way) changes from one texel of the whole light's map to the next, along x and along y;
// absolute values.
Eigen::Vector2d depthPerTexel(const LightFrame& light, int mapSize, const Eigen::Vector3d& world,
                              const Eigen::Vector3d& normal);

// The bias in a frame with one map whose reads cover the same number of texels whatever the
// picture: point reads, bilinear reads, or a summed-area table of fixed size.
class ReceiverBias {
 public:
  // A plane seen edge-on gains depth without bound from texel to texel: the slope's part of the
  // bias is at most this, in normalised depth.
  static constexpr double largest = 0.1;

  ReceiverBias(const LightFrame& light, const FrameSettings& frame);

  // z_r in [0,1] of a world point on a plane with this normal (world, of any length, either way).
  double receiver(const Eigen::Vector3d& world, const Eigen::Vector3d& normal) const;

 private:
  LightFrame light_;
  int mapSize_;
  double constant_, texels_;  // how many texels' gain of depth is subtracted
};

}  // namespace umbra
