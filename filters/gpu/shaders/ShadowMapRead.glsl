// Reads of the shadow map: what a technique's GLSL finds around itself.
// UMBRA_CHANNELS is defined before it. Positions are in texels from the map's top-left corner,
// y down; texel centres sit at half-integers.

uniform sampler2D umbraDepthMap;         // linear depth, row 0 on top
uniform sampler2DArray umbraChannelMap;  // four channels a layer, row 0 on top
uniform int umbraBilinear;               // 0: the nearest texel, 1: the four nearest
uniform int umbraRadius;                 // of the kernel, texels
uniform float umbraWeights[65];          // of the kernel along one axis, from its centre outwards
uniform float umbraLow[UMBRA_CHANNELS];  // a channel's value is low + stored * span
uniform float umbraSpan[UMBRA_CHANNELS];

vec2 umbraPosition = vec2(0.0);  // of the read, set by the host before it asks for visibility

float umbraDepthAt(ivec2 texel) {
  return texelFetch(umbraDepthMap, clamp(texel, ivec2(0), textureSize(umbraDepthMap, 0) - 1), 0).r;
}

// The first of the texels that the read mixes, and the weight of the second along each axis.
ivec2 umbraFirstTexel(out vec2 second) {
  vec2 corner = umbraBilinear != 0 ? umbraPosition - 0.5 : umbraPosition;
  vec2 first = floor(corner);
  second = umbraBilinear != 0 ? corner - first : vec2(0.0);
  return ivec2(first);
}

float umbraNearestDepth() { return umbraDepthAt(ivec2(floor(umbraPosition))); }

float umbraKernelWeight(int tap) { return abs(tap) <= umbraRadius ? umbraWeights[abs(tap)] : 0.0; }

// Weight of a tap of the kernel convolved with the read's own weights (1 - second, second).
float umbraTapWeight(int tap, float second) {
  return umbraKernelWeight(tap) * (1.0 - second) + umbraKernelWeight(tap - 1) * second;
}

// Exact percentage-closer filtering over the region that this read averages. Equality is lit.
float umbraPercentageCloser(float receiver) {
  vec2 second;
  ivec2 first = umbraFirstTexel(second);
  int last = umbraRadius + umbraBilinear;
  float visible = 0.0;
  for (int y = -umbraRadius; y <= last; ++y) {
    float row = 0.0;
    for (int x = -umbraRadius; x <= last; ++x)
      if (umbraDepthAt(first + ivec2(x, y)) >= receiver) row += umbraTapWeight(x, second.x);
    visible += umbraTapWeight(y, second.y) * row;
  }
  return min(visible, 1.0);
}

vec4 umbraFour(ivec2 texel, int layer) {
  ivec2 inside = clamp(texel, ivec2(0), textureSize(umbraChannelMap, 0).xy - 1);
  return texelFetch(umbraChannelMap, ivec3(inside, layer), 0);
}

// Mixed here and not by the texture unit, whose weights have as few as eight bits.
void umbraReadChannels(out float channels[UMBRA_CHANNELS]) {
  vec2 second;
  ivec2 first = umbraFirstTexel(second);
  for (int layer = 0; layer * 4 < UMBRA_CHANNELS; ++layer) {
    vec4 four = umbraFour(first, layer);
    if (umbraBilinear != 0) {
      vec4 top = mix(four, umbraFour(first + ivec2(1, 0), layer), second.x);
      vec4 bottom = mix(umbraFour(first + ivec2(0, 1), layer),
                        umbraFour(first + ivec2(1, 1), layer), second.x);
      four = mix(top, bottom, second.y);
    }
    for (int c = 0; c < 4 && layer * 4 + c < UMBRA_CHANNELS; ++c) {
      int channel = layer * 4 + c;
      channels[channel] = umbraLow[channel] + umbraSpan[channel] * four[c];
    }
  }
}
