// Reads of the shadow map, which a technique's GLSL finds around itself. These are defined before
// it, so that what a frame does not do costs it nothing (a software renderer executes both sides of
// a branch):
//   UMBRA_CHANNELS  of the technique
//   UMBRA_LAYER_CHANNELS  of each depth layer that the technique stores; 0 where it has no layers
//   UMBRA_PREFILTERED  0 where the technique reads raw texels
//   UMBRA_FILTER    0 point, 1 bilinear, 2 trilinear and anisotropic, 3 summed-area table
//   UMBRA_SAMPLES   depths a texel
//   UMBRA_CASCADES  maps
// Positions are in texels from a map's top-left corner, y down; texel centres sit at half-integers.

#define UMBRA_LAYERS ((UMBRA_CHANNELS + 3) / 4)
#define UMBRA_FOOTPRINTS (UMBRA_FILTER >= 2 || UMBRA_CASCADES > 1)

uniform sampler2DArray umbraDepthMap;    // linear depth; layer: cascade * samples + sample
uniform sampler2DArray umbraChannelMap;  // four channels a layer: cascade * UMBRA_LAYERS + layer
uniform int umbraRadius;                 // of the kernel, texels
uniform float umbraWeights[65];          // of the kernel along one axis, from its centre outwards
uniform float umbraLow[UMBRA_CHANNELS];  // a channel's value is low + stored * span
uniform float umbraSpan[UMBRA_CHANNELS];
#if UMBRA_CASCADES > 1
uniform vec3 umbraCascadeWindows[4];  // left, top and side in the whole light's (u, v)
int umbraCascade = 0;
#else
const int umbraCascade = 0;
#endif

// These describe the read; they are set before the technique is asked for visibility.
vec2 umbraPosition = vec2(0.0);               // in the map of umbraCascade
vec3 umbraFootprint = vec3(0.0, 0.0, 1.0);  // texels along x and y, and probes; see umbraShade

ivec2 umbraMapSize() { return textureSize(umbraDepthMap, 0).xy; }

float umbraSampleDepth(ivec2 texel, int number) {
  ivec2 inside = clamp(texel, ivec2(0), umbraMapSize() - 1);
  return texelFetch(umbraDepthMap, ivec3(inside, umbraCascade * UMBRA_SAMPLES + number), 0).r;
}

ivec2 umbraNearestTexel() {
  return clamp(ivec2(floor(umbraPosition)), ivec2(0), umbraMapSize() - 1);
}

// The depth of the texel's first sample.
float umbraNearestDepth() { return umbraSampleDepth(umbraNearestTexel(), 0); }

// The part of a texel's samples that do not block. Equality is lit.
float umbraCloser(ivec2 texel, float receiver) {
#if UMBRA_SAMPLES > 1
  float lit = 0.0;
  for (int i = 0; i < UMBRA_SAMPLES; ++i)
    lit += umbraSampleDepth(texel, i) >= receiver ? 1.0 : 0.0;
  return lit / float(UMBRA_SAMPLES);
#else
  return umbraSampleDepth(texel, 0) >= receiver ? 1.0 : 0.0;
#endif
}

vec4 umbraFour(ivec2 texel, int layer) {
  ivec2 inside = clamp(texel, ivec2(0), textureSize(umbraChannelMap, 0).xy - 1);
  return texelFetch(umbraChannelMap, ivec3(inside, umbraCascade * UMBRA_LAYERS + layer), 0);
}
