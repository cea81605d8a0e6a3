// Shows the shaded picture, or one quantity of it, and hands the scene's depth to what is drawn
// over it. UMBRA_VIEW: 0 shaded, 1 visibility, 2 error, 3 depth, 4 layers,
// 5 cascades.

uniform sampler2D umbraColour;    // the shaded picture
uniform sampler2D umbraSurfaces;  // Surface.glsl decodes them
uniform sampler2D umbraDepth;     // of the camera, [0,1]
#if UMBRA_FOOTPRINTS
uniform sampler2D umbraFootprints;
#endif
uniform ivec2 umbraOrigin;  // of the viewport in the window, pixels
uniform vec3 umbraNoErrorColour;
uniform vec3 umbraBleedingColour;
uniform vec3 umbraDarkeningColour;
uniform float umbraFullError;  // the error that has its full colour, above 0
uniform vec3 umbraLayerColours[8];  // taken in turn
uniform vec3 umbraCascadeColours[4];

layout(location = 0) out vec4 umbraShown;

vec3 umbraErrorColour(float error) {
  vec3 end = error > 0.0 ? umbraBleedingColour : umbraDarkeningColour;
  return mix(umbraNoErrorColour, end, min(abs(error) / umbraFullError, 1.0));
}

float umbraError(vec4 surface, vec4 footprint) {
  // A surface that faces away receives nothing from the light, whatever the visibility.
  if (umbraFacesAway(surface) || !umbraIsInMap(surface)) return 0.0;
  return surface.w - umbraReferenceAt(surface, footprint);
}

// A little of the shading stays, without hue, so that shapes can be told apart.
float umbraShading(vec3 colour) {
  return mix(0.7, 1.0, smoothstep(0.0, 0.8, dot(colour, vec3(0.30, 0.59, 0.11))));
}

#if UMBRA_VIEW == 4
vec3 umbraLayerColour(float receiver) {
  vec2 place = umbraLayer(receiver);
  int layer = int(place.x);
  return mix(umbraLayerColours[layer % 8], umbraLayerColours[(layer + 1) % 8], place.y);
}
#endif

#if UMBRA_VIEW == 5
vec3 umbraCascadeColour(vec4 surface, vec4 footprint) {
  if (!umbraIsInMap(surface)) return vec3(1.0);
  int cascade = int(footprint.w);
  return mix(umbraCascadeColours[cascade], umbraCascadeColours[min(cascade + 1, 3)],
             fract(footprint.w));
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - umbraOrigin;
  float depth = texelFetch(umbraDepth, pixel, 0).r;
  if (depth == 1.0) discard;  // the background is the window's
  gl_FragDepth = depth;
  vec4 colour = texelFetch(umbraColour, pixel, 0);
  umbraShown = vec4(colour.rgb, 1.0);
#if UMBRA_VIEW != 0
  vec4 surface = texelFetch(umbraSurfaces, pixel, 0), footprint = vec4(0.0, 0.0, 1.0, 0.0);
#if UMBRA_FOOTPRINTS
  footprint = texelFetch(umbraFootprints, pixel, 0);
#endif
#endif
#if UMBRA_VIEW == 1
  umbraShown.rgb = vec3(umbraFacesAway(surface) ? 0.0 : surface.w);
#elif UMBRA_VIEW == 2
  umbraShown.rgb = umbraShading(colour.rgb) * umbraErrorColour(umbraError(surface, footprint));
#elif UMBRA_VIEW == 3
  umbraShown.rgb = vec3(1.0 - umbraReceiverOf(surface));
#elif UMBRA_VIEW == 4
  umbraShown.rgb = umbraShading(colour.rgb) * umbraLayerColour(umbraReceiverOf(surface));
#elif UMBRA_VIEW == 5
  umbraShown.rgb = umbraShading(colour.rgb) * umbraCascadeColour(surface, footprint);
#endif
}
