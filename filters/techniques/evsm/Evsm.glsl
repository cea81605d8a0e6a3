// Exponential variance shadow maps (Lauritzen 2008, §4.2). Two channels: the moments of
// e^{c₊(z−½)}. Four channels: those of −e^{−c₋(z−½)} follow.

uniform float umbra_positive_exponent;  // c₊, per unit of depth
#if UMBRA_CHANNELS == 4
uniform float umbra_negative_exponent;  // c₋
#endif
uniform float umbra_min_variance;     // depth²
uniform float umbra_bleed_reduction;  // [0, 1)

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  channels[0] = exp(umbra_positive_exponent * (z - 0.5));
  channels[1] = channels[0] * channels[0];
#if UMBRA_CHANNELS == 4
  channels[2] = -exp(-umbra_negative_exponent * (z - 0.5));
  channels[3] = channels[2] * channels[2];
#endif
}

// The Chebyshev bound (eq. 3.3) in one warp. The bound does not change when warped depth is
// measured in units of |g(z_r)|, and then nothing overflows: `mean` and `second` are the moments
// in that unit, `t` the receiver there, 1 or −1, and the slope of the warp is c.
float umbraBound(float mean, float second, float t, float c) {
  float distance = t - mean;
  if (distance <= 0.0) return 1.0;
  float variance = max(second - mean * mean, umbra_min_variance * c * c);
  float bound = variance / (variance + distance * distance);
  return clamp((bound - umbra_bleed_reduction) / (1.0 - umbra_bleed_reduction), 0.0, 1.0);
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  // Divided twice: the square of g(z_r) itself would underflow for a receiver near the light.
  float g = exp(umbra_positive_exponent * (receiver - 0.5));
  float visibility = umbraBound(channels[0] / g, channels[1] / g / g, 1.0, umbra_positive_exponent);
#if UMBRA_CHANNELS == 4
  g = exp(-umbra_negative_exponent * (receiver - 0.5));
  visibility = min(visibility, umbraBound(channels[2] / g, channels[3] / g / g, -1.0,
                                          umbra_negative_exponent));
#endif
  return visibility;
}
