// Shared by both reductions. Channels are reduced as they are stored: the linear map of a
// normalised format changes neither means nor extremes.

uniform sampler2DArray umbraSource;

uniform ivec2 umbraAxis;                // (1,0) along rows, (0,1) along columns
uniform int umbraRadius;                // texels
// Per channel: 0 mean, 1 max, −1 min (a max of negatives). Cascades follow each other in layers.
uniform vec4 umbraSigns[UMBRA_LAYERS];

// Tap of a line, the edge texel repeated; minima turned into maxima.
vec4 umbraTap(ivec2 texel, int layer) {
  ivec2 inside = clamp(texel, ivec2(0), textureSize(umbraSource, 0).xy - 1);
  vec4 value = texelFetch(umbraSource, ivec3(inside, layer), 0);
  return mix(value, -value, lessThan(umbraSigns[layer % UMBRA_LAYERS], vec4(0.0)));
}

// Extremes take the better of two, means (already weighted) their sum.
vec4 umbraCombine(vec4 a, vec4 b, int layer) {
  return mix(max(a, b), a + b, equal(umbraSigns[layer % UMBRA_LAYERS], vec4(0.0)));
}

void umbraStore(ivec2 texel, int layer, vec4 value, float meanFactor) {
  bvec4 isMin = lessThan(umbraSigns[layer % UMBRA_LAYERS], vec4(0.0));
  bvec4 isMean = equal(umbraSigns[layer % UMBRA_LAYERS], vec4(0.0));
  umbraStoreTexel(ivec3(texel, layer), mix(mix(value, -value, isMin), value * meanFactor, isMean));
}
