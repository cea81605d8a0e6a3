// Makes one mip level from the one below it: each texel reduces four. z: layers.
layout(local_size_x = 8, local_size_y = 8) in;

uniform int umbraSourceLevel;

vec4 umbraBelow(ivec3 texel) {
  // Only the map itself can end within a texel of the level above it: its edge repeats.
  ivec2 inside = min(texel.xy, textureSize(umbraSource, umbraSourceLevel).xy - 1);
  return texelFetch(umbraSource, ivec3(inside, texel.z), umbraSourceLevel);
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (any(greaterThanEqual(texel.xy, imageSize(umbraTarget).xy))) return;
  ivec3 below = ivec3(2 * texel.xy, texel.z);
  vec4 a = umbraBelow(below), b = umbraBelow(below + ivec3(1, 0, 0));
  vec4 c = umbraBelow(below + ivec3(0, 1, 0)), d = umbraBelow(below + ivec3(1, 1, 0));
  // A sum of four large exponentials leaves the range of a float where their mean does not.
  vec4 mean = (0.25 * a + 0.25 * b) + (0.25 * c + 0.25 * d);
  vec4 signs = umbraSigns[texel.z % UMBRA_LAYERS];
  vec4 extreme = mix(max(max(a, b), max(c, d)), min(min(a, b), min(c, d)),
                     lessThan(signs, vec4(0.0)));
  umbraStoreTexel(texel, mix(extreme, mean, equal(signs, vec4(0.0))));
}
