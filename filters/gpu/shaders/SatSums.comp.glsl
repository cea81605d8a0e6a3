// One pass of recursive doubling (Hensley et al. 2005, §3.1, with UMBRA_TERMS in place of two): each
// node adds up terms that lie a step apart along one axis. UMBRA_FIRST takes the terms from the
// channels. UMBRA_SAT_PRECISION: 0 floats less their centre, 1 integers, 2 floats.
layout(local_size_x = 8, local_size_y = 8) in;

#if UMBRA_FIRST
uniform sampler2DArray umbraChannels;
uniform usampler2DArray umbraCentres;  // one texel: the bits of what is subtracted
#else
uniform usampler2DArray umbraSource;
#endif
uniform vec4 umbraLow[UMBRA_LAYERS];  // integers: the fraction is (stored - low) / span
uniform vec4 umbraSpan[UMBRA_LAYERS];
uniform ivec2 umbraStep;  // along one axis; 0 along the other
layout(binding = 0) writeonly uniform uimage2DArray umbraTarget;

#if UMBRA_SAT_PRECISION == 1
#define UmbraSum uvec4
uvec4 umbraBits(uvec4 sum) { return sum; }
uvec4 umbraOfBits(uvec4 bits) { return bits; }
#else
#define UmbraSum vec4
uvec4 umbraBits(vec4 sum) { return floatBitsToUint(sum); }
vec4 umbraOfBits(uvec4 bits) { return uintBitsToFloat(bits); }
#endif

UmbraSum umbraTerm(ivec2 node, int layer) {
#if UMBRA_FIRST
  // Nothing lies left of column 0 or above row 0.
  if (any(lessThan(node, ivec2(1)))) return UmbraSum(0);
  vec4 value = texelFetch(umbraChannels, ivec3(node - 1, layer), 0);
#if UMBRA_SAT_PRECISION == 1
  int kind = layer % UMBRA_LAYERS;
  return uvec4(roundEven(clamp((value - umbraLow[kind]) / umbraSpan[kind], 0.0, 1.0) * 65535.0));
#elif UMBRA_SAT_PRECISION == 0
  return value - uintBitsToFloat(texelFetch(umbraCentres, ivec3(0, 0, layer), 0));
#else
  return value;
#endif
#else
  return umbraOfBits(texelFetch(umbraSource, ivec3(node, layer), 0));
#endif
}

void main() {
  ivec3 id = ivec3(gl_GlobalInvocationID);  // node and layer
  ivec2 nodes = imageSize(umbraTarget).xy - ivec2(0, 1);  // the last row is for the centres
  if (any(greaterThanEqual(id.xy, nodes))) return;
  UmbraSum sum = umbraTerm(id.xy, id.z);
  for (int i = 1; i < UMBRA_TERMS; ++i) {
    ivec2 before = id.xy - i * umbraStep;
    if (any(lessThan(before, ivec2(0)))) break;
    sum += umbraTerm(before, id.z);
  }
  imageStore(umbraTarget, id, umbraBits(sum));
}
