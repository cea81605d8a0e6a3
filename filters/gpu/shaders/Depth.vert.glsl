//VTK::System::Dec
// The whole vertex stage of the depth pass: casters stand in world coordinates.

in vec4 vertexMC;

uniform mat4 umbraWorldToLight;
uniform mat4 umbraLightToClip;  // y turned round: row 0 of the map is its top row

out vec4 umbraLightPosition;  // homogeneous

void main() {
  vec4 light = umbraWorldToLight * vertexMC;
  umbraLightPosition = light;
  gl_Position = umbraLightToClip * light;
}
