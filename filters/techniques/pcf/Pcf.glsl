// Percentage-closer filtering: the channel is depth, every texel of the region is compared.

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  channels[0] = z;
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  return umbraPercentageCloser(receiver);
}
