// Percentage-closer filtering: the channel is depth. Every texel of the region is compared, or
// those under a disc of points, umbraDiscPoints, that is turned from texel to texel.

uniform int umbra_taps;  // 0 all, 1 the disc
uniform int umbra_poisson_taps;

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  channels[0] = z;
}

// The number of the disc's rotation about a texel: a hash.
uint umbraDiscTurn(ivec2 texel) {
  uint hash = uint(texel.x) * 0x9E3779B1u ^ uint(texel.y) * 0x85EBCA77u;
  hash ^= hash >> 15;
  hash *= 0x2C1B3C6Du;
  hash ^= hash >> 13;
  return hash >> 26;
}

float umbraDiscCloser(float receiver) {
  ivec2 texel = umbraNearestTexel();
  ivec2 turn = umbraDiscRotations[umbraDiscTurn(texel)];
  ivec2 window = 2 * umbraReach() + 1;
  float lit = 0.0, all = 0.0;
  for (int tap = 0; tap < umbra_poisson_taps; ++tap) {
    ivec2 point = umbraDiscPoints[tap];
    ivec2 turned =
        ivec2(turn.x * point.x - turn.y * point.y, turn.y * point.x + turn.x * point.y);
    ivec2 offset = (turned * window + (1 << 20)) >> 21;  // 1024² is the disc's radius
    float weight = umbraKernelAt(offset);
    lit += weight * umbraCloser(texel + offset, receiver);
    all += weight;
  }
  return lit / all;
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  return umbra_taps == 0 ? umbraPercentageCloser(receiver) : min(umbraDiscCloser(receiver), 1.0);
}
