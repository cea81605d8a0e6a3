// Reads of a summed-area table (UMBRA_FILTER 3), after ShadowMapRead.glsl: the mean over a box of
// umbraFootprint.xy texels about the position, texels by the part of them that is inside; beyond the
// map's border its edge texels repeat. UMBRA_SAT_PRECISION as in SatSums.comp.glsl.

// Node (x, y): the sum of the texels left of x and above y; layers as umbraChannelMap. The last row
// holds what was subtracted from each texel.
uniform usampler2DArray umbraSat;

// The box, from the corner of the texel that holds the position: small numbers keep their digits.
ivec2 umbraBox(out vec2 low, out vec2 high) {
  vec2 corner = floor(umbraPosition);
  low = umbraPosition - corner - 0.5 * umbraFootprint.xy;
  high = umbraPosition - corner + 0.5 * umbraFootprint.xy;
  return ivec2(corner);
}

// Exact percentage-closer filtering over the box.
float umbraPercentageCloser(float receiver) {
  vec2 low, high;
  ivec2 origin = umbraBox(low, high);
  ivec2 first = ivec2(floor(low)), last = ivec2(ceil(high)) - 1;
  float visible = 0.0;
  for (int y = first.y; y <= last.y; ++y) {
    float row = 0.0;
    for (int x = first.x; x <= last.x; ++x)
      row += (min(high.x, float(x + 1)) - max(low.x, float(x))) *
             umbraCloser(origin + ivec2(x, y), receiver);
    visible += (min(high.y, float(y + 1)) - max(low.y, float(y))) * row;
  }
  return min(visible / ((high.x - low.x) * (high.y - low.y)), 1.0);
}

#if UMBRA_SAT_PRECISION == 1
// Differences are exact, modulo 2^32, however often the sums ran over: what they stand for is less.
#define UmbraSum uvec4
uvec4 umbraSum(ivec2 node, int layer) { return texelFetch(umbraSat, ivec3(node, layer), 0); }
vec4 umbraMeanOf(uvec4 sum) { return vec4(sum) / 65535.0; }
#else
#define UmbraSum vec4
vec4 umbraSum(ivec2 node, int layer) {
  return uintBitsToFloat(texelFetch(umbraSat, ivec3(node, layer), 0));
}
vec4 umbraMeanOf(vec4 sum) { return sum; }
#endif

// Along one axis the box is a first texel, whole ones, and a last: the nodes about them, and each
// one's weight in the mean. What lies beyond the border adds to the edge texel's weight.
void umbraSatAxis(float low, float high, int origin, int size, out ivec4 nodes, out vec3 weights) {
  int first = clamp(origin + int(floor(low)), 0, size - 1);
  int last = clamp(origin + int(ceil(high)) - 1, first, size - 1);
  nodes = ivec4(first, first + 1, last, last + 1);
  weights = first == last ? vec3(high - low, 0.0, 0.0)
                          : vec3(float(first + 1 - origin) - low, 1.0, high - float(last - origin));
  weights /= high - low;
}

// Nine rectangles between sixteen nodes: with weights that are all positive nothing cancels but the
// sums themselves. A bilinear read of the table at the box's corners gives the same.
vec4 umbraBoxMean(int layer) {
  vec2 low, high;
  ivec2 origin = umbraBox(low, high), size = textureSize(umbraSat, 0).xy - ivec2(1, 2);
  ivec4 across, down;
  vec3 weightX, weightY;
  umbraSatAxis(low.x, high.x, origin.x, size.x, across, weightX);
  umbraSatAxis(low.y, high.y, origin.y, size.y, down, weightY);
  vec4 mean = vec4(0.0);
  UmbraSum above[3], here[3];
  for (int j = 0; j < 4; ++j) {
    UmbraSum left = umbraSum(ivec2(across[0], down[j]), layer);
    for (int i = 0; i < 3; ++i) {
      UmbraSum right = umbraSum(ivec2(across[i + 1], down[j]), layer);
      here[i] = right - left;
      left = right;
      if (j > 0) mean += weightX[i] * weightY[j - 1] * umbraMeanOf(here[i] - above[i]);
    }
    above = here;
  }
#if UMBRA_SAT_PRECISION == 0
  mean += uintBitsToFloat(texelFetch(umbraSat, ivec3(0, size.y + 1, layer), 0));
#endif
  return mean;
}

vec4 umbraReadFour(int layer) {
#if UMBRA_PREFILTERED
  return umbraBoxMean(umbraCascade * UMBRA_LAYERS + layer);
#else
  return umbraFour(ivec2(floor(umbraPosition)), layer);  // no table is built
#endif
}
