// Stores of channels, for UMBRA_HALF 1 into 16-bit floats, for UMBRA_STEPS over 0 into normalised
// integers of so many steps (255 or 65535). Drivers may convert to these by any rounding they like
// (some cut the digits off, some round what they have rounded already); here every value is rounded
// to the nearest stored one first, ties to the even one, as the reference does.

layout(binding = 0) writeonly uniform image2DArray umbraTarget;

float umbraNearestHalf(float value) {
  float size = abs(value);
  if (size >= 65520.0) return sign(value) * uintBitsToFloat(0x7f800000u);  // infinity
  // Subnormal halves are multiples of 2^-24.
  if (size < 6.103515625e-5) return roundEven(value * 16777216.0) / 16777216.0;
  // Ten bits of the mantissa stay, ties go to the even one.
  uint bits = floatBitsToUint(value);
  bits += 0xfffu + ((bits >> 13) & 1u);
  return uintBitsToFloat(bits & ~0x1fffu);
}

// The nearest n / UMBRA_STEPS. The product fraction * UMBRA_STEPS is rounded, and a rounded one may
// be a tie where the exact one is not: 0.9f * 255 is just below 229.5. With UMBRA_STEPS = 2^b - 1
// the exact product is 2^b fraction - fraction, and what rounding that difference loses is known
// (Knuth's two-sum); it decides the tie.
float umbraNearestStep(float fraction) {
  fraction = clamp(fraction, 0.0, 1.0);
  const float steps = float(UMBRA_STEPS);
  precise float large = (steps + 1.0) * fraction;  // a power of two: exact
  precise float product = large - fraction;
  precise float back = product - large;
  precise float lost = (large - (product - back)) + (-fraction - back);
  float below = floor(product);
  if (product - below == 0.5 && lost != 0.0) return (lost > 0.0 ? below + 1.0 : below) / steps;
  return roundEven(product) / steps;
}

void umbraStoreTexel(ivec3 texel, vec4 value) {
#if UMBRA_HALF
  for (int c = 0; c < 4; ++c) value[c] = umbraNearestHalf(value[c]);
#elif UMBRA_STEPS > 0
  for (int c = 0; c < 4; ++c) value[c] = umbraNearestStep(value[c]);
#endif
  imageStore(umbraTarget, texel, value);
}
