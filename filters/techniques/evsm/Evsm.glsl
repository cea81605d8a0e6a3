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

// The Chebyshev bound (eq. 3.3) in one warp, with the receiver at t there and a slope of c·t. The
// bound does not depend on the unit of warped depth: measured in the larger of |t| and |mean|, no
// square leaves the range of a float.
float umbraBound(float mean, float second, float t, float c) {
  if (t <= mean) return 1.0;
  float unit = max(abs(t), abs(mean));
  mean /= unit;
  t /= unit;
  float distance = t - mean;
  float slope = c * t;
  float variance = max(second / unit / unit - mean * mean, umbra_min_variance * slope * slope);
  float bound = variance / (variance + distance * distance);
  return clamp((bound - umbra_bleed_reduction) / (1.0 - umbra_bleed_reduction), 0.0, 1.0);
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  float rising = exp(umbra_positive_exponent * (receiver - 0.5));
  float visibility = umbraBound(channels[0], channels[1], rising, umbra_positive_exponent);
#if UMBRA_CHANNELS == 4
  float mirrored = -exp(-umbra_negative_exponent * (receiver - 0.5));
  visibility = min(visibility, umbraBound(channels[2], channels[3], mirrored,
                                          umbra_negative_exponent));
#endif
  return visibility;
}
