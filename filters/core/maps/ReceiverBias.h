// The depth that a surface is compared with: its own, lowered as the shaded frame lowers it.
#pragma once

#include <Eigen/Core>

#include "filters/core/maps/Region.h"
#include "filters/core/scene/Light.h"
#include "filters/core/settings/FrameSettings.h"

namespace umbra {

// How much the normalised depth of the plane through `world` with this normal (of any length,
// either way) changes from one texel of the whole light's map to the next, along x and along y;
// absolute values.
Eigen::Vector2d depthPerTexel(const LightFrame& light, int mapSize, const Eigen::Vector3d& world,
                              const Eigen::Vector3d& normal);

// How far the centres of the texels that a read averages lie from its position, at most, along
// either axis. `finer` is the side of the map's texel, in which the footprint is told, in texels of
// the coarsest cascade that is read, in which the reach is.
Eigen::Vector2d readReach(const ReadPoint& read, const FrameSettings& frame, double finer = 1.0);

// z_r in [0,1] of a surface at depth `z`: less the frame's constant bias, and less what its plane
// gains over the slope's texels and, where the bias follows the receiver's plane, over the `reach`
// of the read. `perTexel` is depthPerTexel of the texels that the reach counts.
double biasedReceiver(double z, const Bias& bias, const Eigen::Vector2d& perTexel,
                      const Eigen::Vector2d& reach);

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
  Bias bias_;
  Eigen::Vector2d reach_;
};

}  // namespace umbra
