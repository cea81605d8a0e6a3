// From a depth map on the GPU to a technique's prefiltered channels on the GPU.
#pragma once

#include <cstddef>

#include "filters/core/FrameSettings.h"
#include "filters/core/Technique.h"
#include "filters/gpu/BakeStage.h"
#include "filters/gpu/gl/Program.h"
#include "filters/gpu/gl/Texture.h"

namespace umbra {

// Bytes of the textures that a square map of these settings takes on the GPU: the depth, the
// encoded channels and, where there is something to prefilter, the reduced ones and those between
// its two axes. More channels than two fill whole layers of four.
std::size_t textureBytes(const FrameSettings& settings, const Technique& technique);

// Every call needs a current context (4.5 core) and leaves no program bound. Textures are as large
// as the depth map and have its top row first.
class ChannelBaker {
 public:
  // Linear depth, one 32-bit float a texel.
  gl::Texture& depthMap() { return depth_; }
  void uploadDepth(const DepthMap& map);

  // Encodes every texel into `format` (any but Double).
  void encode(Technique& technique, StorageFormat format);
  // Reduces what `encode` left over the kernel: 32-bit between the axes, `format` at the end. The
  // cost per texel does not grow with the radius of a box. Where the kernel is empty or the
  // technique reads raw texels, the encoded channels stand for the prefiltered ones.
  void prefilter(const Kernel& kernel);

  // What the shaded frame reads.
  const gl::Texture& channelMap() const { return stage(BakeStage::Prefiltered); }
  // Interleaved channels as values, not as stored fractions.
  Image<float> read(BakeStage stage) const;
  // Takes `channels` for the stage: the tests feed each stage with the reference's last one.
  void upload(BakeStage stage, const Image<float>& channels);

  // For each pixel (u, v, z_r, ·) of `reads`: visibility and exact percentage-closer filtering,
  // both 1 where (u, v) is outside [0,1]. Two floats a pixel in the row order of `reads`.
  std::vector<float> evaluate(const gl::Texture& reads, Technique& technique, const Kernel& kernel,
                              ReadFilter read);

  void releaseGraphicsResources();

 private:
  const gl::Texture& stage(BakeStage stage) const;
  void reduceAlong(int x, int y, const gl::Texture& source, const gl::Texture& target,
                   const Kernel& kernel);

  gl::ProgramCache programs_;
  gl::Texture depth_, encoded_, half_, reduced_;
  std::vector<Channel> layout_;
  StorageFormat format_ = StorageFormat::Float;
  bool prefilterable_ = true;  // of the technique last encoded
  bool filtered_ = false;      // whether reduced_ holds the prefiltered channels
};

}  // namespace umbra
