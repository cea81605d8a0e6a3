// Declarations that the shading pass puts into VTK's own fragment shader, after the technique's.

uniform mat4 umbraViewToLight;  // rigid
uniform mat4 umbraLightToClip;  // y turned round
uniform vec4 umbraToLight;      // view space: the light's position and 1, or the way to it and 0
uniform float umbraNear;         // world units
uniform float umbraPerDistance;  // 1 / (far − near)
uniform float umbraConstantBias;  // normalised depth
uniform float umbraSlopeTexels;   // texels whose depth gain is subtracted as well

// A plane seen edge-on gains depth without bound from texel to texel. Such a surface catches
// hardly any light; a tenth of the depth range keeps it from casting its receiver to the front.
const float umbraLargestBias = 0.1;

// How much deeper, in normalised depth, the plane through `point` with `normal` (both light
// space) lies one texel further along x and along y; absolute values.
vec2 umbraDepthPerTexel(vec3 point, vec3 normal) {
  vec2 size = vec2(textureSize(umbraDepthMap, 0));
  vec2 step = 2.0 / (size * abs(vec2(umbraLightToClip[0][0], umbraLightToClip[1][1])));
#if !UMBRA_SPOT
  return abs(normal.xy / normal.z) * step * umbraPerDistance;
#else
  // Distance along the ray q = (x, y, −1) is d(q) = |q| (n·p) / (n·q): differentiate by x and y.
  vec3 q = point / -point.z;
  float along = dot(normal, q), ray = length(q);
  vec2 gradient =
      dot(normal, point) * (q.xy / (ray * along) - ray * normal.xy / (along * along));
  return abs(gradient) * step * umbraPerDistance;
#endif
}

// (u, v, z_r, visibility); z_r is negated where the surface faces away from the light.
// `position` and `shadingNormal` in view space.
vec4 umbraShade(vec3 position, vec3 shadingNormal) {
  vec3 point = (umbraViewToLight * vec4(position, 1.0)).xyz;
  vec4 clip = umbraLightToClip * vec4(point, 1.0);
  vec2 uv = 0.5 + 0.5 * clip.xy / clip.w;
  float distance = UMBRA_SPOT != 0 ? length(point) : -point.z;
  float z = (distance - umbraNear) * umbraPerDistance;

  // The triangle's own normal: an interpolated one tilts the plane and misses.
  vec2 gain = umbraDepthPerTexel(point, cross(dFdx(point), dFdy(point)));
  float slopeBias = umbraSlopeTexels * (gain.x + gain.y);
  // Written so that a NaN from an exactly edge-on plane ends at the limit too.
  float bias = umbraConstantBias + (slopeBias < umbraLargestBias ? slopeBias : umbraLargestBias);
  float receiver = clamp(z - bias, 0.0, 1.0);

  float visibility = 1.0;
  bool inside = clip.w > 0.0 && all(greaterThanEqual(uv, vec2(0.0))) &&
                all(lessThanEqual(uv, vec2(1.0)));
  if (inside) {
    umbraPosition = uv * vec2(textureSize(umbraDepthMap, 0));
    float channels[UMBRA_CHANNELS];
    umbraReadChannels(channels);
    visibility = umbraVisibility(channels, receiver);
  } else if (uv.x < 0.0 || clip.w <= 0.0) {
    // A negative u marks pixels without a surface: what leaves the map to the left (or lies
    // behind a spot light) is recorded to the right of it.
    uv.x = 2.0 - min(uv.x, 0.0);
  }
  bool away = dot(shadingNormal, umbraToLight.xyz - umbraToLight.w * position) <= 0.0;
  return vec4(uv, away ? -receiver : receiver, visibility);
}
