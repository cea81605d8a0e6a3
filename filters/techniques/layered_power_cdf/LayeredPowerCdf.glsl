// The power CDF in layers: mean, minimum and maximum of every layer's warped depth (Gumbau et al.
// 2011; layers as in Lauritzen 2008, §4.1).

const int umbraLayers = UMBRA_CHANNELS / UMBRA_LAYER_CHANNELS;

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  for (int i = 0; i < umbraLayers; ++i) {
    float warped = umbraWarp(i, z);
    channels[3 * i] = warped;
    channels[3 * i + 1] = warped;
    channels[3 * i + 2] = warped;
  }
}

float umbraVisibilityIn(int layer, float channels[UMBRA_LAYER_CHANNELS], float receiver) {
  return umbraPowerVisibility(channels[0], channels[1], channels[2], umbraWarp(layer, receiver));
}

vec2 umbraLayer(float receiver) { return umbraLayerAt(receiver, umbraLayers); }
