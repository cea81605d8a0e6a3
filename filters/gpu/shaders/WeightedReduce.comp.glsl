// The weighted mean along one axis, tap by tap, together with minima and maxima over the same
// window.
layout(local_size_x = 8, local_size_y = 8) in;

uniform float umbraWeights[65];  // from the kernel's centre outwards

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  int layer = int(gl_GlobalInvocationID.z);
  if (any(greaterThanEqual(texel, textureSize(umbraSource, 0).xy))) return;
  bvec4 isMean = equal(umbraSigns[layer % UMBRA_LAYERS], vec4(0.0));
  vec4 reduced = umbraTap(texel, layer);
  reduced = mix(reduced, reduced * umbraWeights[0], isMean);
  for (int tap = 1; tap <= umbraRadius; ++tap) {
    vec4 before = umbraTap(texel - tap * umbraAxis, layer);
    vec4 after = umbraTap(texel + tap * umbraAxis, layer);
    vec4 both = umbraCombine(before, after, layer);
    reduced = umbraCombine(reduced, mix(both, both * umbraWeights[tap], isMean), layer);
  }
  umbraStore(texel, layer, reduced, 1.0);
}
