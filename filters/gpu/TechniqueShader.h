// A technique's GLSL with the reads that it expects around it, and the uniforms of both.
#pragma once

#include <string>

#include "filters/core/FrameSettings.h"
#include "filters/core/Technique.h"
#include "filters/gpu/gl/Program.h"

namespace umbra {

// Channels are packed four to a layer of a texture array.
int layersFor(int channels);

// How a channel's value lies in its texel: value = low + span * stored. (0, 1) for the floating
// formats, the channel's own range for the normalised ones.
struct ChannelRange {
  float low = 0.0f, span = 1.0f;
};
ChannelRange rangeOf(const Channel& channel, StorageFormat format);

// UMBRA_CHANNELS, ShadowMapRead.glsl and the technique's text; no #version and no main. Its
// samplers are umbraDepthMap and umbraChannelMap.
std::string techniqueSource(const Technique& technique);
// The same as a whole compute shader, around `body` with its main.
std::string computeSource(const Technique& technique, const std::string& body);

// Parameters, derived uniforms and channel ranges. Does not bind the program.
void setTechniqueUniforms(GLuint program, Technique& technique, StorageFormat format);
void setReadUniforms(GLuint program, const Kernel& kernel, ReadFilter read);
// From the centre outwards: radius + 1 floats.
std::vector<float> halfWeights(const Kernel& kernel);

}  // namespace umbra
