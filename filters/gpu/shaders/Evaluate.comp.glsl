// Visibility and exact percentage-closer filtering for a table of reads: (u, v) in [0,1] from the
// map's top-left corner, z_r, unused. A read outside the map, or none (u < 0), is lit.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D umbraReads;
layout(binding = 0, rg32f) writeonly uniform image2D umbraTarget;  // visibility, reference

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, textureSize(umbraReads, 0)))) return;
  vec3 read = texelFetch(umbraReads, pixel, 0).xyz;
  vec2 result = vec2(1.0);
  if (all(greaterThanEqual(read.xy, vec2(0.0))) && all(lessThanEqual(read.xy, vec2(1.0)))) {
    float receiver = abs(read.z);
    umbraPosition = read.xy * vec2(textureSize(umbraDepthMap, 0));
    float channels[UMBRA_CHANNELS];
    umbraReadChannels(channels);
    result = vec2(umbraVisibility(channels, receiver), umbraPercentageCloser(receiver));
  }
  imageStore(umbraTarget, pixel, vec4(result, 0.0, 0.0));
}
