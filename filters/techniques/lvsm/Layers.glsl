// Depth cut into overlapping layers (Lauritzen 2008, §4.1), shared by every layered technique.

uniform float umbra_layer_low[16];   // p of every layer, depth
uniform float umbra_layer_high[16];  // q
uniform float umbra_layer_end[16];   // the split that ends it; the last is 1
uniform float umbra_overlap;         // δ, depth

float umbraWarp(int layer, float z) {  // eq. 4.2
  float low = umbra_layer_low[layer];
  return clamp((z - low) / (umbra_layer_high[layer] - low), 0.0, 1.0);
}

// The layer that holds `receiver`, and the weight of the next layer's estimate: above 0 only within
// the overlap of the two.
vec2 umbraLayerAt(float receiver, int layers) {
  int holder = 0;
  for (int i = 0; i + 1 < layers; ++i) holder += receiver > umbra_layer_end[i] ? 1 : 0;
  // Splits ascend, so that the nearest one is an end of the layer that holds the receiver.
  int blended = -1;  // the layer before the nearest split within reach of the overlap
  float nearest = umbra_overlap;
  float above = holder > 0 ? receiver - umbra_layer_end[holder - 1] : nearest;
  if (above < nearest) {
    nearest = above;
    blended = holder - 1;
  }
  float below = holder + 1 < layers ? umbra_layer_end[holder] - receiver : nearest;
  if (below < nearest) blended = holder;
  if (blended < 0) return vec2(float(holder), 0.0);
  float farther = (receiver - umbra_layer_end[blended] + umbra_overlap) / (2.0 * umbra_overlap);
  return vec2(float(blended), farther);
}
