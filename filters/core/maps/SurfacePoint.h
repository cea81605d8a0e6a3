// Where a surface is read in the shadow map, and the visibility there.
#pragma once

#include <Eigen/Core>

#include "filters/core/maps/Region.h"

namespace umbra {

// What the shaded frame knows of the surface that one of its pixels shows, or would know of a
// point.
struct SurfacePoint {
  double u = 0.0, v = 0.0;  // in its cascade's map, [0,1] from the top-left corner, v down
  double receiver = 0.0;    // z_r, biased, [0,1]
  double visibility = 1.0;  // as the GPU computed it
  bool facesLight = true;   // false: turned away from the light, which adds nothing there
  Eigen::Vector3d world{0.0, 0.0, 0.0};
  Footprint footprint;  // in texels of its cascade's map, for the filters that have one
  int cascade = 0;
  double nextCascade = 0.0;  // weight of the next cascade in a seam, else 0

  // Whether the map covers it.
  bool isInMap() const { return u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0; }
  // Whether it takes part in shadows: what faces away, or leaves the map, has no error.
  bool receivesShadow() const { return facesLight && isInMap(); }
};

}  // namespace umbra
