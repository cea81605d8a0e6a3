// The power-function estimate from mean, minimum and maximum (Gumbau et al. 2011), shared by the
// plain and the layered technique.

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

// Depths of any one warp. Rounding may leave the mean just outside [low, high].
float umbraPowerVisibility(float storedMean, float low, float high, float receiver) {
  float mean = clamp(storedMean, low, high);
  if (receiver <= mean) return 1.0;
  if (receiver >= high || mean <= low) return 0.0;
  float range = high - low;
  float above = high - mean;
  float beta = (mean - low) / above;  // eq. 3
  float logT = umbraLogOfRest((high - receiver) / range, (receiver - low) / range);
  float logMean = umbraLogOfRest(above / range, (mean - low) / range);
  return clamp(umbraOneMinusExp(beta * logT) / umbraOneMinusExp(beta * logMean), 0.0, 1.0);  // eq. 4
}
