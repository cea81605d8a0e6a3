// The uniforms of the light that both the depth pass and the shading pass set.
#pragma once

#include "filters/core/scene/Light.h"
#include "filters/gpu/gl/Program.h"

namespace umbra {

// Sets umbraLightToClip, umbraSpot, umbraNear and umbraPerDistance of `program`.
inline void setLightUniforms(GLuint program, const LightFrame& frame) {
  const Eigen::Matrix4f lightToClip = frame.lightToClip.cast<float>();
  gl::setUniformMatrix4(program, "umbraLightToClip", lightToClip.data());
  gl::setUniform(program, "umbraSpot", frame.kind == LightKind::Spot ? 1 : 0);
  gl::setUniform(program, "umbraNear", float(frame.nearDistance));
  gl::setUniform(program, "umbraPerDistance",
                 float(1.0 / (frame.farDistance - frame.nearDistance)));
}

}  // namespace umbra
