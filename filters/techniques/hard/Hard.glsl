// The plain shadow map: the channel is depth, compared once at the nearest texel.

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  channels[0] = z;
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  return receiver <= umbraNearestDepth() ? 1.0 : 0.0;
}
