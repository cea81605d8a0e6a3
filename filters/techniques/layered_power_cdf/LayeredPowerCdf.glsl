// The power CDF in layers: mean, minimum and maximum of every layer's warped depth (Gumbau et al.
// 2011; layers as in Lauritzen 2008, §4.1).

uniform float umbra_layer_low[16];   // p of every layer, depth
uniform float umbra_layer_high[16];  // q
uniform float umbra_layer_end[16];   // the split that ends it; the last is 1
uniform float umbra_overlap;         // δ, depth

const int umbraLayers = UMBRA_CHANNELS / 3;

float umbraWarp(int layer, float z) {  // Lauritzen 2008, eq. 4.2
  float low = umbra_layer_low[layer];
  return clamp((z - low) / (umbra_layer_high[layer] - low), 0.0, 1.0);
}

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  for (int i = 0; i < umbraLayers; ++i) {
    float warped = umbraWarp(i, z);
    channels[3 * i] = warped;
    channels[3 * i + 1] = warped;
    channels[3 * i + 2] = warped;
  }
}

// ln(1 − y) for y in [0, 1). `rest` is 1 − y, formed without y where that is more exact. Near
// y = 0 log() would lose what y adds to 1: there ln(1 − y) = −2 artanh(y/(2 − y)), whose series
// in s = y/(2 − y) < 1/3 has reached float precision after seven terms.
float umbraLogOfRest(float y, float rest) {
  if (y > 0.5) return log(rest);
  float s = y / (2.0 - y);
  float q = s * s;
  float series =
      1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0 +
      q * (1.0 / 11.0 + q * (1.0 / 13.0))))));
  return -2.0 * s * series;
}

// 1 − e^x for x ≤ 0; by its series near 0, where the subtraction would cancel.
float umbraOneMinusExp(float x) {
  if (x < -0.5) return 1.0 - exp(x);
  float series =
      1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0 * (1.0 +
      x / 6.0 * (1.0 + x / 7.0 * (1.0 + x / 8.0))))));
  return -x * series;
}

float umbraVisibilityIn(int layer, float channels[UMBRA_CHANNELS], float receiver) {
  float low = channels[3 * layer + 1], high = channels[3 * layer + 2];
  float mean = clamp(channels[3 * layer], low, high);
  float warped = umbraWarp(layer, receiver);
  if (warped <= mean) return 1.0;
  if (warped >= high || mean <= low) return 0.0;
  float range = high - low;
  float above = high - mean;
  float beta = (mean - low) / above;  // eq. 3
  float logT = umbraLogOfRest((high - warped) / range, (warped - low) / range);
  float logMean = umbraLogOfRest(above / range, (mean - low) / range);
  return clamp(umbraOneMinusExp(beta * logT) / umbraOneMinusExp(beta * logMean), 0.0, 1.0);  // eq. 4
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
