// The depth that a surface is compared with: its own, lowered as the shaded frame lowers it.
#pragma once

#include <Eigen/Core>

#include "filters/core/FrameSettings.h"
#include "filters/core/Light.h"

namespace umbra {

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
  // By how much the plane's normalised depth changes from one texel to the next along x and y.
  Eigen::Vector2d depthPerTexel(const Eigen::Vector3d& world, const Eigen::Vector3d& normal) const;

  LightFrame light_;
  double constant_, texels_;  // texels of the slope that are subtracted
  Eigen::Vector2d step_;      // a texel's side at unit distance before the light, world units
};

}  // namespace umbra
