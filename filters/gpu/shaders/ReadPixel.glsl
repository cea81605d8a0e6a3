// What one pixel reads: after ShadowMapRead.glsl and the reads of its filter, which define
// umbraPercentageCloser and umbraReadFour.

// The technique's.
#if UMBRA_LAYER_CHANNELS > 0
vec2 umbraLayer(float receiver);
float umbraVisibilityIn(int layer, float channels[UMBRA_LAYER_CHANNELS], float receiver);
#else
float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver);
#endif

// How many texels on either side of the nearest one the read averages, wherever between texels it
// is.
ivec2 umbraReach() {
#if UMBRA_FILTER == 3
  return ivec2(0.5 * (max(umbraFootprint.xy, vec2(1.0)) - 1.0));
#else
  return ivec2(umbraRadius);
#endif
}

// The kernel's weight of a texel beside the nearest, within its radius.
float umbraKernelAt(ivec2 offset) {
#if UMBRA_FILTER == 3
  return 1.0;  // a box
#elif UMBRA_FILTER == 2
  return (umbraCumulative(offset.x) - umbraCumulative(offset.x - 1)) *
         (umbraCumulative(offset.y) - umbraCumulative(offset.y - 1));
#else
  return umbraKernelWeight(offset.x) * umbraKernelWeight(offset.y);
#endif
}

#if UMBRA_LAYER_CHANNELS > 0
// The channels of one depth layer. Where they lie in two textures, these are read in a loop, because
// a software renderer would run both sides of a branch.
void umbraReadLayer(int depthLayer, out float channels[UMBRA_LAYER_CHANNELS]) {
  int first = depthLayer * UMBRA_LAYER_CHANNELS, last = first + UMBRA_LAYER_CHANNELS - 1;
#if 4 % UMBRA_LAYER_CHANNELS == 0
  vec4 four = umbraReadFour(first / 4);
  for (int c = 0; c < UMBRA_LAYER_CHANNELS; ++c)
    channels[c] = umbraLow[first + c] + umbraSpan[first + c] * four[(first + c) % 4];
#else
  for (int layer = first / 4; layer <= last / 4; ++layer) {
    vec4 four = umbraReadFour(layer);
    for (int c = 0; c < UMBRA_LAYER_CHANNELS; ++c) {
      int channel = first + c;
      if (channel / 4 == layer)
        channels[c] = umbraLow[channel] + umbraSpan[channel] * four[channel % 4];
    }
  }
#endif
}

// The estimate of the layer that holds the receiver, mixed with the next one's within the overlap.
float umbraVisibilityOfRead(float receiver) {
  vec2 place = umbraLayer(receiver);
  float visibility = 0.0;
  for (int part = 0; part < (place.y > 0.0 ? 2 : 1); ++part) {
    float channels[UMBRA_LAYER_CHANNELS];
    int depthLayer = int(place.x) + part;
    umbraReadLayer(depthLayer, channels);
    visibility += umbraVisibilityIn(depthLayer, channels, receiver) *
                  (part == 0 ? 1.0 - place.y : place.y);
  }
  return visibility;
}
#else
float umbraVisibilityOfRead(float receiver) {
  float channels[UMBRA_CHANNELS];
  for (int layer = 0; layer < UMBRA_LAYERS; ++layer) {
    vec4 four = umbraReadFour(layer);
    for (int c = 0; c < 4 && layer * 4 + c < UMBRA_CHANNELS; ++c) {
      int channel = layer * 4 + c;
      channels[channel] = umbraLow[channel] + umbraSpan[channel] * four[c];
    }
  }
  return umbraVisibility(channels, receiver);
}
#endif

// `uv` and `footprint` belong to the pixel's own cascade; the read may be of another one. A coarser
// map has fewer texels in the same place, but a box of a summed-area table is never narrower than
// the kernel, nor wider than its integers can sum.
void umbraSetRead(vec2 uv, vec4 footprint, int cascade) {
  umbraFootprint = footprint.xyz;
#if UMBRA_CASCADES > 1
  umbraCascade = cascade;
  int own = int(footprint.w);
  if (cascade != own) {
    vec3 from = umbraCascadeWindows[own], to = umbraCascadeWindows[cascade];
    uv = (from.xy + from.z * uv - to.xy) / to.z;
    umbraFootprint.xy *= from.z / to.z;
#if UMBRA_FILTER == 3
    umbraFootprint.xy = clamp(umbraFootprint.xy, vec2(float(2 * umbraRadius + 1)),
                              vec2(float(UMBRA_LARGEST_BOX)));
#endif
  }
#endif
  umbraPosition = uv * vec2(umbraMapSize());
}

// Evaluates the read that was set last: exact percentage-closer filtering, or the technique's
// visibility. `exact` is a constant wherever the function is called, so that compilers leave the
// other case out.
float umbraOfRead(const bool exact, float receiver) {
  if (exact) return umbraPercentageCloser(receiver);
  return umbraVisibilityOfRead(receiver);
}

// Evaluates one pixel: (u, v, z_r, ·), with (u, v) in [0,1] of its cascade's map, and (x, y,
// probes, cascade + weight of the next cascade). It mixes two cascades' visibilities, not their
// channels.
float umbraOfPixel(const bool exact, vec4 surface, vec4 footprint) {
  float receiver = abs(surface.z);
#if UMBRA_CASCADES > 1
  float mixed = 0.0, next = fract(footprint.w);
  // A loop, because a software renderer runs both sides of a branch for every pixel but ends a loop
  // with the last that goes on.
  for (int part = 0; part < (next > 0.0 ? 2 : 1); ++part) {
    umbraSetRead(surface.xy, footprint, int(footprint.w) + part);
    mixed += umbraOfRead(exact, receiver) * (part == 0 ? 1.0 - next : next);
  }
  return mixed;
#else
  umbraSetRead(surface.xy, footprint, 0);
  return umbraOfRead(exact, receiver);
#endif
}

float umbraVisibilityAt(vec4 surface, vec4 footprint) {
  return umbraOfPixel(false, surface, footprint);
}

float umbraReferenceAt(vec4 surface, vec4 footprint) {
  return umbraOfPixel(true, surface, footprint);
}
