#version 430
// Copies each sample of a multisampled depth into a layer of its own.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2DMS umbraSamples;
uniform int umbraFirstLayer;
layout(binding = 0, r32f) writeonly uniform image2DArray umbraTarget;

void main() {
  ivec3 id = ivec3(gl_GlobalInvocationID);  // texel and sample
  if (any(greaterThanEqual(id.xy, textureSize(umbraSamples)))) return;
  vec4 depth = texelFetch(umbraSamples, id.xy, id.z);
  imageStore(umbraTarget, ivec3(id.xy, umbraFirstLayer + id.z), depth);
}
