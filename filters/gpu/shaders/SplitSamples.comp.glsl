// Makes a sample between every four texels (Lauritzen 2008, §4.1.2): the depth of the second
// occluder, μ + σ, and its weight, σ². It works in double until both are stored, so that they equal
// the reference's floats.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2DArray umbraDepthMap;  // linear depth; layer 0 is the first map's first sample
layout(rg32f, binding = 0) uniform writeonly image2D umbraSamples;
uniform float umbraLowestWeight;
uniform float umbraHighestWeight;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(umbraSamples)))) return;
  double depths[4];
  for (int i = 0; i < 4; ++i)
    depths[i] = double(texelFetch(umbraDepthMap, ivec3(at + ivec2(i & 1, i >> 1), 0), 0).r);
  precise double mean = 0.25lf * (depths[0] + depths[1] + depths[2] + depths[3]);
  precise double variance = 0.0lf;
  for (int i = 0; i < 4; ++i)
    variance += 0.25lf * (depths[i] - mean) * (depths[i] - mean);
  precise double value = mean + sqrt(variance);
  float weight = clamp(float(variance), umbraLowestWeight, umbraHighestWeight);
  imageStore(umbraSamples, at, vec4(float(value), weight, 0.0, 0.0));
}
