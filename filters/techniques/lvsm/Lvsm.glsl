// Layered variance shadow maps: two moments of every layer's warped depth (Lauritzen 2008, §4.1).

uniform float umbra_layer_low[16];   // p of every layer, depth
uniform float umbra_layer_high[16];  // q
uniform float umbra_layer_end[16];   // the split that ends it; the last is 1
uniform float umbra_overlap;         // δ, depth
uniform float umbra_min_variance;    // depth², unwarped
uniform float umbra_bleed_reduction;  // [0, 1)

const int umbraLayers = UMBRA_CHANNELS / 2;

float umbraWarp(int layer, float z) {  // eq. 4.2
  float low = umbra_layer_low[layer];
  return clamp((z - low) / (umbra_layer_high[layer] - low), 0.0, 1.0);
}

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  for (int i = 0; i < umbraLayers; ++i) {
    float warped = umbraWarp(i, z);
    channels[2 * i] = warped;
    channels[2 * i + 1] = warped * warped;
  }
}

float umbraVisibilityIn(int layer, float channels[UMBRA_CHANNELS], float receiver) {
  float mean = channels[2 * layer];
  float distance = umbraWarp(layer, receiver) - mean;
  if (distance <= 0.0) return 1.0;
  float width = umbra_layer_high[layer] - umbra_layer_low[layer];
  float smallest = umbra_min_variance / (width * width);
  float variance = max(channels[2 * layer + 1] - mean * mean, smallest);
  float bound = variance / (variance + distance * distance);  // eq. 3.3
  return clamp((bound - umbra_bleed_reduction) / (1.0 - umbra_bleed_reduction), 0.0, 1.0);
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  int holder = 0;
  int blended = -1;  // the layer before the nearest split within reach of the overlap
  float nearest = umbra_overlap;
  for (int i = 0; i + 1 < umbraLayers; ++i) {
    float distance = abs(receiver - umbra_layer_end[i]);
    if (receiver > umbra_layer_end[i]) holder = i + 1;
    if (distance < nearest) {
      nearest = distance;
      blended = i;
    }
  }
  if (blended < 0) return umbraVisibilityIn(holder, channels, receiver);
  float farther = (receiver - umbra_layer_end[blended] + umbra_overlap) / (2.0 * umbra_overlap);
  return mix(umbraVisibilityIn(blended, channels, receiver),
             umbraVisibilityIn(blended + 1, channels, receiver), farther);
}
