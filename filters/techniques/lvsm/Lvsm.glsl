// Layered variance shadow maps: two moments of every layer's warped depth (Lauritzen 2008, §4.1).

uniform float umbra_min_variance;    // depth², unwarped
uniform float umbra_bleed_reduction;  // [0, 1)

const int umbraLayers = UMBRA_CHANNELS / UMBRA_LAYER_CHANNELS;

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  for (int i = 0; i < umbraLayers; ++i) {
    float warped = umbraWarp(i, z);
    channels[2 * i] = warped;
    channels[2 * i + 1] = warped * warped;
  }
}

float umbraVisibilityIn(int layer, float channels[UMBRA_LAYER_CHANNELS], float receiver) {
  float mean = channels[0];
  float distance = umbraWarp(layer, receiver) - mean;
  if (distance <= 0.0) return 1.0;
  float width = umbra_layer_high[layer] - umbra_layer_low[layer];
  float smallest = umbra_min_variance / (width * width);
  float variance = max(channels[1] - mean * mean, smallest);
  if (variance <= 0.0) return 0.0;  // the square of a small distance vanishes, too
  float bound = variance / (variance + distance * distance);  // eq. 3.3
  return clamp((bound - umbra_bleed_reduction) / (1.0 - umbra_bleed_reduction), 0.0, 1.0);
}

vec2 umbraLayer(float receiver) { return umbraLayerAt(receiver, umbraLayers); }
