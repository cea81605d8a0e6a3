// Evaluates visibility and exact percentage-closer filtering for a table of reads: (u, v) in [0,1]
// from the map's top-left corner, z_r, unused. Beside it stands a table of footprints, for filters
// and cascades that have any. A read outside the map, or an empty entry (u < 0), is lit.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D umbraReads;
#if UMBRA_FOOTPRINTS
uniform sampler2D umbraFootprints;
#endif
layout(binding = 0, rg32f) writeonly uniform image2D umbraTarget;  // visibility, reference

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, textureSize(umbraReads, 0)))) return;
  vec4 surface = texelFetch(umbraReads, pixel, 0), footprint = vec4(0.0, 0.0, 1.0, 0.0);
#if UMBRA_FOOTPRINTS
  footprint = texelFetch(umbraFootprints, pixel, 0);
#endif
  vec2 result = vec2(1.0);
  if (umbraIsInMap(surface))
    result = vec2(umbraVisibilityAt(surface, footprint), umbraReferenceAt(surface, footprint));
  imageStore(umbraTarget, pixel, vec4(result, 0.0, 0.0));
}
