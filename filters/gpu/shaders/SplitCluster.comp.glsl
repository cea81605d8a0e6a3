// Adds up the samples of each cluster that fall to one invocation: every stride-th one in both
// directions, so that neighbouring invocations read neighbouring samples.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D umbraSamples;                   // value and weight
uniform float umbraEnds[UMBRA_CLUSTERS];          // a cluster has the values up to its end
layout(std430, binding = 0) writeonly buffer Sums {
  UmbraSums umbraSums[];  // cluster by cluster, one for each invocation
};

void main() {
  UmbraSums sums[UMBRA_CLUSTERS];
  for (int i = 0; i < UMBRA_CLUSTERS; ++i) sums[i] = umbraNoSums();
  ivec2 size = textureSize(umbraSamples, 0);
  ivec2 stride = ivec2(gl_NumWorkGroups.xy * gl_WorkGroupSize.xy);
  ivec2 own = ivec2(gl_GlobalInvocationID.xy);
  for (int y = own.y; y < size.y; y += stride.y) {
    for (int x = own.x; x < size.x; x += stride.x) {
      vec2 texel = texelFetch(umbraSamples, ivec2(x, y), 0).rg;
      if (texel.g <= 0.0) continue;
      int cluster = 0;
      for (int i = 0; i + 1 < UMBRA_CLUSTERS; ++i) cluster += int(texel.r > umbraEnds[i]);
      double u = double(texel.r) - 0.5lf;
      double weighted = double(texel.g) * u;
      sums[cluster].weight += double(texel.g);
      sums[cluster].first += weighted;
      sums[cluster].second += weighted * u;
      sums[cluster].low = min(sums[cluster].low, texel.r);
      sums[cluster].high = max(sums[cluster].high, texel.r);
    }
  }
  int invocations = stride.x * stride.y;
  for (int i = 0; i < UMBRA_CLUSTERS; ++i)
    umbraSums[i * invocations + own.y * stride.x + own.x] = sums[i];
}
