// The power CDF in layers: mean, minimum and maximum of every layer's warped depth (Gumbau et al.
// 2011; layers as in Lauritzen 2008, §4.1).

const int umbraLayers = UMBRA_CHANNELS / 3;

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  for (int i = 0; i < umbraLayers; ++i) {
    float warped = umbraWarp(i, z);
    channels[3 * i] = warped;
    channels[3 * i + 1] = warped;
    channels[3 * i + 2] = warped;
  }
}

float umbraVisibilityIn(int layer, float channels[UMBRA_CHANNELS], float receiver) {
  return umbraPowerVisibility(channels[3 * layer], channels[3 * layer + 1], channels[3 * layer + 2],
                              umbraWarp(layer, receiver));
}

vec2 umbraLayer(float receiver) { return umbraLayerAt(receiver, umbraLayers); }

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  vec2 place = umbraLayer(receiver);
  int layer = int(place.x);
  float visibility = umbraVisibilityIn(layer, channels, receiver);
  if (place.y == 0.0) return visibility;
  return mix(visibility, umbraVisibilityIn(layer + 1, channels, receiver), place.y);
}
