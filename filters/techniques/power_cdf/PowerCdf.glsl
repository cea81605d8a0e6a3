// Power CDF shadow maps: the channels are mean, minimum and maximum depth (Gumbau et al. 2011).

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  channels[0] = z;
  channels[1] = z;
  channels[2] = z;
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  return umbraPowerVisibility(channels[0], channels[1], channels[2], receiver);
}
