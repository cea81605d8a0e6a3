// A technique's GLSL with the reads that it expects around it, and the uniforms of both.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"
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

// How the maps are laid out and read.
struct MapReads {
  Kernel kernel;
  ReadFilter filter = ReadFilter::Bilinear;
  int samples = 1;                                    // depths a texel
  int cascades = 1;                                   // maps
  SatPrecision satPrecision = SatPrecision::Centred;  // of the table that reads use, if any
  // Left, top and side of each cascade's window in the whole light's (u, v).
  std::array<Eigen::Vector3f, CascadeSettings::largestCount> windows{
      Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(),
      Eigen::Vector3f::Zero()};

  // Whether a read depends on more than its position.
  bool needFootprints() const {
    return cascades > 1 || (filter != ReadFilter::Point && filter != ReadFilter::Bilinear);
  }
};

// Whether reads of this filter need mip levels.
bool readsLevels(ReadFilter filter);
// The format whose stored values a read gives: a table of integers holds 16-bit fractions of each
// channel's range, whatever it was made from.
StorageFormat readFormat(StorageFormat stored, const MapReads& reads);

// A shader's text: what ShadowMapRead.glsl asks for, that file, the filter's reads, and the
// technique. It has no #version and no main. Its samplers are umbraDepthMap and umbraChannelMap,
// umbraMipMap with mip levels, and umbraSat with a table.
std::string techniqueSource(const Technique& technique, const MapReads& reads);
// The same as a whole compute shader; `body` holds its main.
std::string computeSource(const Technique& technique, const MapReads& reads,
                          const std::string& body);

// Sets parameters, derived uniforms and the ranges of the channels that are read. Does not bind the
// program.
void setTechniqueUniforms(GLuint program, Technique& technique, StorageFormat format);
void setReadUniforms(GLuint program, const MapReads& reads);
// The kernel's weights from the centre outwards: radius + 1 floats.
std::vector<float> halfWeights(const Kernel& kernel);

}  // namespace umbra
