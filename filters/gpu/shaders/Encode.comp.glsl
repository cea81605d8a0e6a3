// Encodes each texel's depths by the technique's umbraEncode, four channels to a layer. Where there
// are several samples, their means or extremes are taken. z: cascades.
layout(local_size_x = 8, local_size_y = 8) in;

uniform vec4 umbraSigns[UMBRA_LAYERS];  // as in Reduce.glsl

void umbraEncodeSample(ivec3 texel, int number, out float channels[UMBRA_CHANNELS]) {
  ivec3 place = ivec3(texel.xy, texel.z * UMBRA_SAMPLES + number);
  for (int c = 0; c < UMBRA_CHANNELS; ++c) channels[c] = 0.0;
  umbraEncode(texelFetch(umbraDepthMap, place, 0).r, channels);
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(texel.xy, umbraMapSize()))) return;
  float channels[UMBRA_CHANNELS];
  umbraEncodeSample(texel, 0, channels);
#if UMBRA_SAMPLES > 1
  for (int number = 1; number < UMBRA_SAMPLES; ++number) {
    float more[UMBRA_CHANNELS];
    umbraEncodeSample(texel, number, more);
    for (int c = 0; c < UMBRA_CHANNELS; ++c) {
      float sign = umbraSigns[c / 4][c % 4];
      channels[c] = sign == 0.0  ? channels[c] + more[c]
                    : sign > 0.0 ? max(channels[c], more[c])
                                 : min(channels[c], more[c]);
    }
  }
  for (int c = 0; c < UMBRA_CHANNELS; ++c)
    if (umbraSigns[c / 4][c % 4] == 0.0) channels[c] /= float(UMBRA_SAMPLES);
#endif
  for (int layer = 0; layer < UMBRA_LAYERS; ++layer) {
    vec4 four = vec4(0.0);
    for (int c = 0; c < 4 && layer * 4 + c < UMBRA_CHANNELS; ++c) {
      int channel = layer * 4 + c;
      four[c] = (channels[channel] - umbraLow[channel]) / umbraSpan[channel];
    }
    umbraStoreTexel(ivec3(texel.xy, texel.z * UMBRA_LAYERS + layer), four);
  }
}
