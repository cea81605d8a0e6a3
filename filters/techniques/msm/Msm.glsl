// Moment shadow maps: four power moments of depth, or their optimised quantisation (Peters & Klein
// 2015).

uniform float umbra_moment_bias;
uniform float umbra_bleed_reduction;  // [0, 1)
uniform int umbra_basis;              // 0 moments, 1 quantised

const float umbraRoot3 = 1.7320508;

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  float z2 = z * z;
  if (umbra_basis == 0) {
    channels[0] = z;
    channels[1] = z2;
    channels[2] = z2 * z;
    channels[3] = z2 * z2;
    return;
  }
  float x = 2.0 * z - 1.0;
  float x2 = x * x;
  channels[0] = x * (1.5 - 2.0 * x2) + 0.5;
  channels[1] = 4.0 * x2 * (1.0 - x2);
  channels[2] = x * umbraRoot3 * (0.5 - x2 * (2.0 / 9.0)) + 0.5;
  channels[3] = 0.5 * x2 * (1.0 + x2);
}

// Turns the moments of x = 2z − 1 in `m` into those of z.
vec4 umbraMomentsOfDepth(vec4 m) {
  return vec4(0.5 * (1.0 + m.x), 0.25 * (1.0 + 2.0 * m.x + m.y),
              0.125 * (1.0 + 3.0 * m.x + 3.0 * m.y + m.z),
              0.0625 * (1.0 + 4.0 * m.x + 6.0 * m.y + 4.0 * m.z + m.w));
}

vec4 umbraMoments(float channels[UMBRA_CHANNELS]) {
  vec4 stored = vec4(channels[0], channels[1], channels[2], channels[3]);
  if (umbra_basis == 0) return stored;
  float odd0 = stored.x - 0.5;
  float odd2 = umbraRoot3 * (stored.z - 0.5);
  return umbraMomentsOfDepth(vec4(odd2 - odd0 / 3.0, stored.w + 0.125 * stored.y,
                                  0.75 * (odd2 - odd0), stored.w - 0.125 * stored.y));
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  vec4 b = mix(umbraMoments(channels), vec4(0.5), umbra_moment_bias);

  // All depths are measured from the mean. B = L D Lᵀ of the Hankel matrix, then B c = (1, t, t²),
  // with c times the last pivot. The floors keep rounding from turning a variance negative.
  float t = receiver - b.x;
  float l21d1 = b.z - b.y * b.x;
  float d1 = max(b.y - b.x * b.x, 1e-7);
  float l21 = l21d1 / d1;
  float d2 = max(b.w - b.y * b.y - l21 * l21d1, 0.0);
  float skew = l21 - 2.0 * b.x;
  float y2 = t * t - d1 - skew * t;
  if (abs(y2) < 1e-12) y2 = 1e-12;  // its root is then as good as infinitely far away
  float c1 = d2 * t / d1 - skew * y2;
  float c0 = d2 - d1 * y2;

  // Roots of y2 t² + c1 t + c0, the smaller first; neither is formed by cancelling subtraction.
  float root = sqrt(max(c1 * c1 - 4.0 * y2 * c0, 0.0));
  float q = c1 < 0.0 ? 0.5 * (root - c1) : -0.5 * (root + c1);
  float one = q / y2;
  float other = q != 0.0 ? c0 / q : one;
  float near = min(one, other);
  float far = max(one, other);

  // A root that rounding has moved across the receiver would turn its depth from lit to occluded,
  // so equality has the width of that rounding.
  const float equal = 2e-6;
  if (t <= near + equal) return 1.0;
  // The weight of the receiver's own depth, 1/(1, t, t²) B⁻¹ (1, t, t²)ᵀ: no term is negative. What
  // of the other weights lies behind it follows from their sum and mean, divided by what is never
  // small, the roots' distance.
  float own = d2 / (d2 * (1.0 + t * t / d1) + y2 * y2);
  float behind = t <= far + equal ? max(-(near + own * (t - near)) / (far - near), 0.0) : 0.0;
  float visibility = min(own + behind, 1.0);
  return clamp((visibility - umbra_bleed_reduction) / (1.0 - umbra_bleed_reduction), 0.0, 1.0);
}
