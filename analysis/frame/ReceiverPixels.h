// Which pixels of a frame take part in shadows.
#pragma once

#include <span>

namespace umbra {

// Whether a pixel receives shadow: a surface is there, faces the light and lies inside the light's
// frame. `surface` holds the pixel's four values (u, v, z_r, visibility) in
// ShadowRenderer::surfaces.
inline bool receivesShadow(std::span<const float> surface) {
  const float u = surface[0], v = surface[1], receiver = surface[2];
  return u >= 0 && u <= 1 && v >= 0 && v <= 1 && receiver > 0;
}

}  // namespace umbra
