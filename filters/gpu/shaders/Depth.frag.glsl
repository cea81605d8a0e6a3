//VTK::System::Dec
//VTK::Output::Dec
// Linear depth in [0,1]: distance to the light's plane (directional) or to the light (spot).

in vec4 umbraLightPosition;  // light space, world units, homogeneous

uniform int umbraSpot;
uniform float umbraNear;
uniform float umbraPerDistance;  // 1 / (far − near)

void main() {
  // The fourth component is 1, but for drivers that interpolate at a sample's place and take the
  // perspective of the texel's centre: both have the same factor too many.
  vec3 position = umbraLightPosition.xyz / umbraLightPosition.w;
  float distance = umbraSpot != 0 ? length(position) : -position.z;
  gl_FragData[0] = vec4(clamp((distance - umbraNear) * umbraPerDistance, 0.0, 1.0), 0.0, 0.0, 1.0);
}
