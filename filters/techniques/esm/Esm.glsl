// Exponential shadow maps: the channel is E[e^{c(z−½)}] (Salvi 2007).

uniform float umbra_exponent;         // c, per unit of depth
uniform float umbra_bleed_reduction;  // [0, 1)

// The smallest normal float: below it an implementation may flush to zero, and a texel at the
// near plane would then be in shadow of itself.
const float umbraSmallest = 1.18e-38;

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  channels[0] = max(exp(umbra_exponent * (z - 0.5)), umbraSmallest);
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  // The receiver's factor falls below the smallest normal float at c = 175; its root does not. Each
  // product is finite up to c = 176 or infinite, which counts as 1.
  float root = exp(-0.5 * umbra_exponent * (receiver - 0.5));
  float ratio = min(channels[0] * root * root, 1.0);
  return clamp((ratio - umbra_bleed_reduction) / (1.0 - umbra_bleed_reduction), 0.0, 1.0);
}
