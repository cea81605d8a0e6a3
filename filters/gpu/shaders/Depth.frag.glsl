//VTK::System::Dec
//VTK::Output::Dec
// Linear depth in [0,1]: distance to the light's plane (directional) or to the light (spot).

in vec3 umbraLightPosition;  // light space, world units

uniform int umbraSpot;
uniform float umbraNear;
uniform float umbraPerDistance;  // 1 / (far − near)

void main() {
  float distance = umbraSpot != 0 ? length(umbraLightPosition) : -umbraLightPosition.z;
  gl_FragData[0] = vec4(clamp((distance - umbraNear) * umbraPerDistance, 0.0, 1.0), 0.0, 0.0, 1.0);
}
