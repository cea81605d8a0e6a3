// Decodes what the shading pass has written of a pixel's surface, (u, v, z_r, visibility), as
// SurfaceImage does in C++: u < 0 where there is no surface; the sign bit of z_r, also of a zero,
// where the surface faces away from the light.

bool umbraFacesAway(vec4 surface) {
  return (floatBitsToUint(surface.z) >> 31) != 0u;
}

float umbraReceiverOf(vec4 surface) {
  return abs(surface.z);
}

// False as well where there is no surface.
bool umbraIsInMap(vec4 surface) {
  return all(greaterThanEqual(surface.xy, vec2(0.0))) && all(lessThanEqual(surface.xy, vec2(1.0)));
}
