// Stores of channels, for UMBRA_HALF 1 into 16-bit floats. Drivers may convert to these by any
// rounding they like (some cut the digits off); here every value is rounded to the nearest half
// first, as the reference does.

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

void umbraStoreTexel(ivec3 texel, vec4 value) {
#if UMBRA_HALF
  for (int c = 0; c < 4; ++c) value[c] = umbraNearestHalf(value[c]);
#endif
  imageStore(umbraTarget, texel, value);
}
