// Convolution shadow maps: sine and cosine of c_k z for k = 1 … M, c_k = π(2k − 1) (Annen et al.
// 2007, eq. 14).

uniform float umbra_coefficient[16];  // 2 a_k/c_k
uniform float umbra_offset;           // o, depth
uniform int umbra_mode;               // 0 offset, 1 scale

const int umbraTerms = UMBRA_CHANNELS / 2;

// c_k x, k from 0 here, taken into [−π, π]: built-in sines lose digits far from 0.
float umbraPhase(int k, float x) {
  float halfTurns = float(2 * k + 1) * x;
  return 3.14159265358979 * (halfTurns - 2.0 * floor(0.5 * halfTurns + 0.5));
}

void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]) {
  for (int k = 0; k < umbraTerms; ++k) {
    float phase = umbraPhase(k, z);
    channels[2 * k] = sin(phase);
    channels[2 * k + 1] = cos(phase);
  }
}

float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver) {
  float d = umbra_mode == 0 ? receiver - umbra_offset : receiver;
  float sum = 0.5;
  for (int k = 0; k < umbraTerms; ++k) {  // eq. 13
    float phase = umbraPhase(k, d);
    sum += umbra_coefficient[k] * (cos(phase) * channels[2 * k] - sin(phase) * channels[2 * k + 1]);
  }
  return clamp(umbra_mode == 1 ? 2.0 * sum : sum, 0.0, 1.0);
}
