// The depth that a surface is compared with: its own, lowered as the shaded frame lowers it.
#pragma once

#include <Eigen/Core>

#include "filters/core/scene/Light.h"
#include "filters/core/settings/FrameSettings.h"

namespace umbra {

// By how much the normalised depth of the plane through `world` with this normal (of any length,
// either way) changes from one texel of the whole light's map to the next along x and y; absolute
// values.
Eigen::Vector2d depthPerTexel(const LightFrame& light, int mapSize, const Eigen::Vector3d& world,
                              const Eigen::Vector3d& normal);

// Of a frame with one map, read where reads cover as much whatever the picture: point, bilinear, or
// a summed-area table of fixed size.
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
  double constant_, texels_;  // texels of the slope that are subtracted
};

}  // namespace umbra
