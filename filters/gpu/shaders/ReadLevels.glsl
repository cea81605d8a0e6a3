// Trilinear and anisotropic reads (UMBRA_FILTER 2), after ShadowMapRead.glsl. With P the next power
// of two of the map's longer side, mip level L has P >> L texels a side; its texel i reduces the
// prefiltered texels [i * 2^L, (i + 1) * 2^L), the map's edge repeated.

uniform sampler2DArray umbraMipMap;  // its level 0 is mip level 1; layers as umbraChannelMap
uniform float umbraWindow[65];  // the kernel's weights of all taps up to this far from its centre

// Texels a side of the level 0 that the others halve: P.
int umbraWholeSide() {
  int side = max(umbraMapSize().x, umbraMapSize().y) - 1;
  side |= side >> 1;
  side |= side >> 2;
  side |= side >> 4;
  side |= side >> 8;
  return side + 1;
}

// The binary logarithm of a value from 1 to 2. Drivers' own logarithms may have few digits.
float umbraLog2(float value) {
  float s = (value - 1.0) / (value + 1.0), q = s * s;
  float series = 1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0 +
                 q * (1.0 / 11.0 + q / 13.0)))));
  return min(2.8853900817779268 * s * series, 1.0);
}

// The finer of the two levels that a footprint mixes, and the weight of the next one, which is 0 at
// the last level, a single texel.
int umbraLevelOf(vec3 footprint, out float next) {
  float whole = float(umbraWholeSide());
  float side = clamp(length(footprint.xy) / footprint.z, 1.0, whole);
  // The logarithm may be off by a digit where the side is about a power of two.
  int level = int(log2(side) + 0.5);
  if (float(1 << level) > side) --level;
  next = umbraLog2(side / float(1 << level));
  return level;
}

// The position of one of the reads that are spread along the footprint's longer axis.
vec2 umbraProbe(int probe) {
  return umbraPosition + umbraFootprint.xy * ((float(probe) + 0.5) / umbraFootprint.z - 0.5);
}

// The two texels of a level that a bilinear read mixes along each axis, and the weight of the
// second.
void umbraLevelTexels(vec2 position, int level, out ivec2 first, out ivec2 last, out vec2 second) {
  vec2 corner = position / float(1 << level) - 0.5;
  vec2 whole = floor(corner);
  ivec2 end = ivec2((umbraWholeSide() >> level) - 1);
  second = corner - whole;
  first = clamp(ivec2(whole), ivec2(0), end);
  last = clamp(ivec2(whole) + 1, ivec2(0), end);
}

// The weight of all of the kernel's taps up to `tap`: half of the whole weight, plus or minus half
// of the weight of the taps that are as near to the centre on either side.
float umbraCumulative(int tap) {
  int distance = min(tap >= 0 ? tap : -1 - tap, umbraRadius);
  return 0.5 + (tap >= 0 ? 0.5 : -0.5) * umbraWindow[distance];
}

// The depths that a bilinear read of a level averages along one axis: two blocks of prefiltered
// texels, each of equal weight and each averaging the kernel's window of depths.
struct UmbraAxis {
  int first, last;  // the depths' range, which may reach beyond the map's edges
  ivec2 begin, end;  // of the blocks, cut off at the map's edge
  vec2 weight;       // of a texel of a block
  float edge;        // weight of the map's last texel for those cut off
  int edgeTexel;
};

UmbraAxis umbraAxisOf(int first, int last, float second, int level, int size) {
  int side = 1 << level;
  ivec2 begin = ivec2(first, last) * side, end = begin + side;
  UmbraAxis axis;
  axis.weight = vec2(1.0 - second, second) / float(side);
  axis.begin = min(begin, ivec2(size));
  axis.end = min(end, ivec2(size));
  axis.edge = dot(axis.weight, vec2(side - (axis.end - axis.begin)));
  axis.edgeTexel = size - 1;
  axis.first = min(axis.begin.x, size - 1) - umbraRadius;
  axis.last = axis.end.y - 1 + umbraRadius;
  return axis;
}

float umbraAxisWeight(UmbraAxis axis, int tap) {
  float weight = axis.edge * (umbraCumulative(tap - axis.edgeTexel) -
                              umbraCumulative(tap - axis.edgeTexel - 1));
  for (int i = 0; i < 2; ++i)
    weight += axis.weight[i] *
              (umbraCumulative(tap - axis.begin[i]) - umbraCumulative(tap - axis.end[i]));
  return weight;
}

float umbraLevelCloser(vec2 position, int level, float receiver) {
  ivec2 first, last;
  vec2 second;
  umbraLevelTexels(position, level, first, last, second);
  UmbraAxis across = umbraAxisOf(first.x, last.x, second.x, level, umbraMapSize().x);
  UmbraAxis down = umbraAxisOf(first.y, last.y, second.y, level, umbraMapSize().y);
  float visible = 0.0;
  for (int y = down.first; y <= down.last; ++y) {
    float row = 0.0;
    for (int x = across.first; x <= across.last; ++x)
      row += umbraAxisWeight(across, x) * umbraCloser(ivec2(x, y), receiver);
    visible += umbraAxisWeight(down, y) * row;
  }
  return visible;
}

// Exact percentage-closer filtering over the region that this read averages.
float umbraPercentageCloser(float receiver) {
  float next, visible = 0.0;
  int level = umbraLevelOf(umbraFootprint, next);
  for (int probe = 0; probe < int(umbraFootprint.z); ++probe) {
    vec2 position = umbraProbe(probe);
    float finer = umbraLevelCloser(position, level, receiver);
    float coarser = next > 0.0 ? umbraLevelCloser(position, level + 1, receiver) : 0.0;
    visible += mix(finer, coarser, next);
  }
  return min(visible / umbraFootprint.z, 1.0);
}

// Reads level 1 and on.
vec4 umbraMipFour(ivec2 texel, int layer, int level) {
  return texelFetch(umbraMipMap, ivec3(texel, umbraCascade * UMBRA_LAYERS + layer), level - 1);
}

vec4 umbraMixed(vec4 a, vec4 b, vec4 c, vec4 d, vec2 second) {
  return mix(mix(a, b, second.x), mix(c, d, second.x), second.y);
}

vec4 umbraReadMip(vec2 position, int layer, int level) {
  ivec2 first, last;
  vec2 second;
  umbraLevelTexels(position, level, first, last, second);
  return umbraMixed(umbraMipFour(first, layer, level),
                    umbraMipFour(ivec2(last.x, first.y), layer, level),
                    umbraMipFour(ivec2(first.x, last.y), layer, level),
                    umbraMipFour(last, layer, level), second);
}

vec4 umbraReadMap(vec2 position, int layer) {
  vec2 corner = position - 0.5, whole = floor(corner);
  ivec2 first = ivec2(whole);
  return umbraMixed(umbraFour(first, layer), umbraFour(first + ivec2(1, 0), layer),
                    umbraFour(first + ivec2(0, 1), layer), umbraFour(first + ivec2(1, 1), layer),
                    corner - whole);
}

vec4 umbraReadFour(int layer) {
#if UMBRA_PREFILTERED
  float next;
  int level = umbraLevelOf(umbraFootprint, next);
  vec4 sum = vec4(0.0);
  for (int probe = 0; probe < int(umbraFootprint.z); ++probe) {
    vec2 position = umbraProbe(probe);
    vec4 four =
        level == 0 ? umbraReadMap(position, layer) : umbraReadMip(position, layer, level);
    if (next > 0.0) four = mix(four, umbraReadMip(position, layer, level + 1), next);
    sum += four;
  }
  return sum / umbraFootprint.z;
#else
  return umbraFour(ivec2(floor(umbraPosition)), layer);  // no levels are built
#endif
}
