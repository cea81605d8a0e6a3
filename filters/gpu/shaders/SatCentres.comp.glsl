#version 430
// Computes for each layer the mean of a grid of at most 128 × 128 texels, which a table subtracts
// before it sums. It need only be near the mean of all texels.
layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2DArray umbraChannels;
layout(binding = 0) writeonly uniform uimage2DArray umbraTarget;  // the bits of floats

shared vec4 umbraSums[256];

void main() {
  ivec2 size = textureSize(umbraChannels, 0).xy, grid = min(size, ivec2(128));
  int layer = int(gl_WorkGroupID.z);
  vec4 sum = vec4(0.0);
  for (int y = int(gl_LocalInvocationID.y); y < grid.y; y += 16)
    for (int x = int(gl_LocalInvocationID.x); x < grid.x; x += 16)
      sum += texelFetch(umbraChannels, ivec3(ivec2(x, y) * size / grid, layer), 0);
  uint index = gl_LocalInvocationIndex;
  umbraSums[index] = sum;
  barrier();
  for (uint apart = 128u; apart > 0u; apart /= 2u) {
    if (index < apart) umbraSums[index] += umbraSums[index + apart];
    barrier();
  }
  if (index == 0u)
    imageStore(umbraTarget, ivec3(0, 0, layer),
               floatBitsToUint(umbraSums[0] / float(grid.x * grid.y)));
}
