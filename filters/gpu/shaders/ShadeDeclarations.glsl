// Declarations that the shading pass puts into VTK's own fragment shader, after the technique's.

uniform mat4 umbraViewToLight;  // rigid
uniform mat4 umbraLightToClip;  // of the whole light; y turned round
uniform vec4 umbraToLight;      // view space: the light's position and 1, or the way to it and 0
uniform float umbraNear;         // world units
uniform float umbraPerDistance;  // 1 / (far − near)
uniform float umbraConstantBias;  // normalised depth
uniform float umbraSlopeTexels;   // texels whose depth gain is subtracted as well
uniform float umbraReceiverPlane;  // 1: also that of the texels that the filter reaches, 0: not
uniform float umbraAnisotropy;     // probes of a footprint, at most; 1 for a trilinear filter

// A plane seen edge-on gains depth without bound from texel to texel. Such a surface catches
// hardly any light; a tenth of the depth range keeps it from casting its receiver to the front.
const float umbraLargestBias = 0.1;

// How much deeper, in normalised depth, the plane through `point` with `normal` (both light
// space) lies one texel of the whole light's map further along x and along y; absolute values.
vec2 umbraDepthPerTexel(vec3 point, vec3 normal) {
  vec2 size = vec2(umbraMapSize());
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

#if UMBRA_CASCADES > 1
uniform vec4 umbraSplitPlane;        // view space: distance along the axis that is split
uniform float umbraCascadeEnds[4];   // such distances, world units
uniform float umbraCascadeSeams[4];  // where each begins to go over into the next

bool umbraHolds(int cascade, vec2 whole) {
  vec3 window = umbraCascadeWindows[cascade];
  return all(greaterThanEqual(whole, window.xy)) && all(lessThanEqual(whole, window.xy + window.z));
}

// The cascade that a point is drawn from, and the weight of the next one, below 1. `whole` is its
// (u, v) on the whole light's map, `distance` is along the split axis. What its own cascade's
// window does not hold is left to the next.
vec2 umbraCascadeOf(vec2 whole, float distance) {
  const int last = UMBRA_CASCADES - 1;
  float cascade = 0.0, next = 0.0;
  bool found = false;
  for (int i = 0; i < last; ++i) {  // unrolled: nothing is indexed by what differs among pixels
    bool own = distance < umbraCascadeEnds[i] && umbraHolds(i, whole) && !found;
    float begin = umbraCascadeSeams[i], seam = umbraCascadeEnds[i] - begin;
    // Less than 1 by so much that the sum with the cascade's number still is no whole one.
    float weight = clamp((distance - begin) / max(seam, 1e-20), 0.0, 0.999999);
    if (own && umbraHolds(i + 1, whole)) next = weight;
    found = found || own;
    cascade += found ? 0.0 : 1.0;
  }
  return vec2(cascade, next);
}
#endif

// The footprint of a pixel whose position on the map moves by `dx` and `dy` (texels) to the next
// pixels: its longer axis, and how many probes are spread along it so that each covers as much as
// the shorter axis. A probe covers at least one texel.
vec3 umbraFootprintOf(vec2 dx, vec2 dy) {
  float longest = float(max(umbraMapSize().x, umbraMapSize().y));
  vec2 axis = dot(dx, dx) > dot(dy, dy) ? dx : dy;
  float longer = length(axis), shorter = min(length(dx), length(dy));
  // Written so that what is no number, at the edge of a spot light's view, ends at the limit too.
  if (!(longer < longest)) {
    axis = vec2(longest, 0.0);
    longer = shorter = longest;
  }
  float probes = clamp(ceil(longer / max(shorter, 1.0)), 1.0, umbraAnisotropy);
  return vec3(axis, probes);
}

#if UMBRA_FILTER == 3
uniform int umbraSatSize;  // of the box: 0 footprint, 1 distance, 2 fixed
uniform float umbraSatDistance;  // within which it grows, world units

// Width and height, in texels, of the box for a pixel whose position on the map moves by `dx` and
// `dy` to the next pixels, at `distance` from the camera: never narrower than the kernel.
vec2 umbraBoxOf(vec2 dx, vec2 dy, float distance) {
  float kernel = float(2 * umbraRadius + 1);
  vec2 box = vec2(kernel);
  if (umbraSatSize == 0) box = max(abs(dx) + abs(dy), kernel);
  if (umbraSatSize == 1) box = vec2(kernel * max(umbraSatDistance / distance, 1.0));
  // Written so that what is no number, at the edge of a spot light's view, ends at the limit too.
  const float largest = float(UMBRA_LARGEST_BOX);
  return vec2(box.x < largest ? box.x : largest, box.y < largest ? box.y : largest);
}
#endif

// How far the centres of the texels that a read averages lie from its position, at most, along
// either axis.
vec2 umbraReachOf(vec3 footprint) {
  float kernel = float(umbraRadius);
#if UMBRA_FILTER == 0
  return vec2(kernel + 0.5);
#elif UMBRA_FILTER == 1
  return vec2(kernel + 1.0);
#elif UMBRA_FILTER == 2
  // One and a half texels of the coarser level, about the outermost probes.
  float next;
  int level = umbraLevelOf(footprint, next);
  float side = float(1 << (next > 0.0 ? level + 1 : level));
  vec2 probes = abs(footprint.xy) * (0.5 - 0.5 / footprint.z);
  return kernel + 1.5 * side - 0.5 + probes;
#else
  return 0.5 * max(footprint.xy, vec2(2.0 * kernel + 1.0)) + 0.5;
#endif
}

// (u, v, z_r, visibility), coded as Surface.glsl and SurfaceImage decode it. (u, v) and
// `footprint` = (x, y, probes, cascade + weight of the next one) are those of its cascade's map.
// `position` and `shadingNormal` in view space.
vec4 umbraShade(vec3 position, vec3 shadingNormal, out vec4 footprint) {
  vec3 point = (umbraViewToLight * vec4(position, 1.0)).xyz;
  vec4 clip = umbraLightToClip * vec4(point, 1.0);
  vec2 uv = 0.5 + 0.5 * clip.xy / clip.w;
  float distance = UMBRA_SPOT != 0 ? length(point) : -point.z;
  float z = (distance - umbraNear) * umbraPerDistance;
  // The triangle's own normal: an interpolated one tilts the plane and misses.
  vec2 gain = umbraDepthPerTexel(point, cross(dFdx(point), dFdy(point)));

  footprint = vec4(0.0, 0.0, 1.0, 0.0);
#if UMBRA_FILTER >= 2
  vec2 dx = dFdx(uv) * vec2(umbraMapSize()), dy = dFdy(uv) * vec2(umbraMapSize());
#endif
  // Sides of texels, in those of the whole light's map: the cascade's, and the coarsest that is
  // read.
  float side = 1.0, coarsest = 1.0;
#if UMBRA_CASCADES > 1
  vec2 cascade = umbraCascadeOf(uv, dot(umbraSplitPlane, vec4(position, 1.0)));
  vec3 window = umbraCascadeWindows[int(cascade.x)];
  uv = (uv - window.xy) / window.z;
  footprint.w = cascade.x + cascade.y;
  side = coarsest = window.z;
  if (cascade.y > 0.0) coarsest = max(side, umbraCascadeWindows[int(cascade.x) + 1].z);
#endif
#if UMBRA_FILTER == 2
  footprint.xyz = umbraFootprintOf(dx / side, dy / side);
#elif UMBRA_FILTER == 3
  footprint.xy = umbraBoxOf(dx / side, dy / side, length(position));
#endif
  // In a seam both cascades have one receiver, with the bias of the coarser one.
  vec2 reach = umbraReachOf(vec3(footprint.xy * side / coarsest, footprint.z));
  float slopeBias = dot(umbraSlopeTexels + umbraReceiverPlane * reach, coarsest * gain);
  // Written so that a NaN from an exactly edge-on plane ends at the limit too.
  float bias = umbraConstantBias + (slopeBias < umbraLargestBias ? slopeBias : umbraLargestBias);
  float receiver = clamp(z - bias, 0.0, 1.0);

  float visibility = 1.0;
  bool inside = clip.w > 0.0 && all(greaterThanEqual(uv, vec2(0.0))) &&
                all(lessThanEqual(uv, vec2(1.0)));
  if (inside) {
    visibility = umbraVisibilityAt(vec4(uv, receiver, 1.0), footprint);
  } else if (uv.x < 0.0 || clip.w <= 0.0) {
    // A negative u marks pixels without a surface: what leaves the map to the left (or lies
    // behind a spot light) is recorded to the right of it.
    uv.x = 2.0 - min(uv.x, 0.0);
  }
  bool away = dot(shadingNormal, umbraToLight.xyz - umbraToLight.w * position) <= 0.0;
  return vec4(uv, away ? -receiver : receiver, visibility);
}
