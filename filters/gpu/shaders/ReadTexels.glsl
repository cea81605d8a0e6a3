// Point and bilinear reads (UMBRA_FILTER 0 and 1), after ShadowMapRead.glsl.

// The first of the texels that the read mixes, and the weight of the second along each axis.
ivec2 umbraFirstTexel(out vec2 second) {
  vec2 corner = umbraPosition - 0.5 * float(UMBRA_FILTER);
  vec2 first = floor(corner);
  second = (corner - first) * float(UMBRA_FILTER);
  return ivec2(first);
}

float umbraKernelWeight(int tap) { return abs(tap) <= umbraRadius ? umbraWeights[abs(tap)] : 0.0; }

// The weight of a tap: the kernel convolved with the read's own weights (1 - second, second).
float umbraTapWeight(int tap, float second) {
  return umbraKernelWeight(tap) * (1.0 - second) + umbraKernelWeight(tap - 1) * second;
}

// Exact percentage-closer filtering over the region that this read averages.
float umbraPercentageCloser(float receiver) {
  vec2 second;
  ivec2 first = umbraFirstTexel(second);
  int last = umbraRadius + UMBRA_FILTER;
  float visible = 0.0;
  for (int y = -umbraRadius; y <= last; ++y) {
    float row = 0.0;
    for (int x = -umbraRadius; x <= last; ++x)
      row += umbraTapWeight(x, second.x) * umbraCloser(first + ivec2(x, y), receiver);
    visible += umbraTapWeight(y, second.y) * row;
  }
  return min(visible, 1.0);
}

// The mix is done here and not by the texture unit, whose weights have as few as eight bits.
vec4 umbraReadFour(int layer) {
  vec2 second;
  ivec2 first = umbraFirstTexel(second);
  vec4 four = umbraFour(first, layer);
#if UMBRA_FILTER == 1
  vec4 top = mix(four, umbraFour(first + ivec2(1, 0), layer), second.x);
  vec4 bottom = mix(umbraFour(first + ivec2(0, 1), layer), umbraFour(first + ivec2(1, 1), layer),
                    second.x);
  four = mix(top, bottom, second.y);
#endif
  return four;
}
