// Each texel's depth through the technique's umbraEncode, four channels to a layer.
layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, textureSize(umbraDepthMap, 0)))) return;
  float channels[UMBRA_CHANNELS];
  for (int c = 0; c < UMBRA_CHANNELS; ++c) channels[c] = 0.0;
  umbraEncode(umbraDepthAt(texel), channels);
  for (int layer = 0; layer * 4 < UMBRA_CHANNELS; ++layer) {
    vec4 four = vec4(0.0);
    for (int c = 0; c < 4 && layer * 4 + c < UMBRA_CHANNELS; ++c) {
      int channel = layer * 4 + c;
      four[c] = (channels[channel] - umbraLow[channel]) / umbraSpan[channel];
    }
    umbraStoreTexel(ivec3(texel, layer), four);
  }
}
