// Variance shadow maps: channels are the moments E[z], E[z²] (Lauritzen 2008, eq. 3.1).

uniform float umbra_min_variance;     // depth²
uniform float umbra_bleed_reduction;  // [0, 1)

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  channels[0] = z;
  channels[1] = z * z;
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  float mean = channels[0];
  float distance = receiver - mean;
  if (distance <= 0.0) return 1.0;
  float variance = max(channels[1] - mean * mean, umbra_min_variance);  // eq. 3.2
  if (variance <= 0.0) return 0.0;  // the square of a small distance vanishes, too
  float bound = variance / (variance + distance * distance);            // eq. 3.3
  return clamp((bound - umbra_bleed_reduction) / (1.0 - umbra_bleed_reduction), 0.0, 1.0);
}
