// From depth maps on the GPU to a technique's prefiltered channels on the GPU.
#pragma once

#include <cstddef>

#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"
#include "filters/gpu/BakeStage.h"
#include "filters/gpu/SummedAreaTable.h"
#include "filters/gpu/TechniqueShader.h"
#include "filters/gpu/gl/Program.h"
#include "filters/gpu/gl/Texture.h"

namespace umbra {

// Bytes of the textures that a square map of these settings takes on the GPU: the depth, the
// encoded channels and, where there is something to prefilter, the reduced ones and those between
// its two axes; mip levels or a summed-area table where the filter reads them. More channels than
// two fill whole layers of four.
std::size_t textureBytes(const FrameSettings& settings, const Technique& technique);

// Every call needs a current context (4.5 core) and leaves no program bound. Textures are as large
// as the depth map and have its top row first. All cascades are of one size and baked at once.
class ChannelBaker {
 public:
  // Makes room for the depths of `cascades` maps with `samples` depths a texel.
  void prepareDepth(int width, int height, int cascades = 1, int samples = 1);
  // Linear depth, an array of 32-bit floats; layer: cascade * samples + sample.
  gl::Texture& depthMap() { return depth_; }
  int cascades() const { return cascades_; }
  int samples() const { return samples_; }
  // Of a cascade there is room for; a map of another size or samples gets room of its own.
  void uploadDepth(const DepthMap& map, int cascade = 0);
  DepthMap readDepth(int cascade = 0) const;

  // Encodes every texel into `format` (any but Double).
  void encode(Technique& technique, StorageFormat format);
  // Reduces what `encode` left over the kernel: 32-bit between the axes, `format` at the end. The
  // cost per texel does not grow with the radius of a box. Where the kernel is empty or the
  // technique reads raw texels, the encoded channels stand for the prefiltered ones.
  void prefilter(const Kernel& kernel);
  // The mip levels of what `prefilter` left, each rounded to the format.
  void buildLevels();
  // Whether they are not built yet; a technique that reads raw texels has none.
  bool needsLevels() const { return prefilterable_ && !levelled_; }

  // The summed-area table of what `prefilter` left.
  void buildSums(SatPrecision precision);
  // As needsLevels(), of such a table.
  bool needsSums(SatPrecision precision) const {
    return prefilterable_ && !(summed_ && sumPrecision_ == precision);
  }

  // What the shaded frame reads. Layer: cascade * layersFor(channels) + layer of the channels.
  const gl::Texture& channelMap() const { return stage(BakeStage::Prefiltered); }
  // Mip levels 1 and on: with P the next power of two of the map's longer side, mip level L has
  // P >> L texels a side. Nothing before they are built.
  const gl::Texture& levelMap() const { return levels_; }
  // As SummedAreaTable lays it out. Nothing before it is built.
  const gl::Texture& sumMap() const { return sums_.texture(); }
  // Interleaved channels as values, not as stored fractions.
  Image<float> read(BakeStage stage, int cascade = 0) const;
  Image<float> readLevel(int level, int cascade = 0) const;  // 1 and on
  // Takes `channels` for the stage: the tests feed each stage with the reference's last one.
  void upload(BakeStage stage, const Image<float>& channels, int cascade = 0);

  // For each pixel (u, v, z_r, ·) of `surfaces`: visibility and exact percentage-closer filtering,
  // both 1 where (u, v) is outside [0,1]. Two floats a pixel in the row order of `surfaces`.
  // `footprints` (x, y, probes, cascade + weight of the next one) may be none where
  // !reads.needFootprints(). Takes cascades and samples as they were prepared.
  std::vector<float> evaluate(const gl::Texture& surfaces, const gl::Texture* footprints,
                              Technique& technique, MapReads reads);

  void releaseGraphicsResources();

 private:
  const gl::Texture& stage(BakeStage stage) const;
  int channelLayers() const { return layersFor(int(layout_.size())); }
  std::vector<float> signs() const;  // as Reduce.glsl has them
  std::string reductionSource(const gl::Texture& target) const;
  Image<float> valuesOf(const std::vector<float>& texels, int width, int height) const;
  void reduceAlong(int x, int y, const gl::Texture& source, const gl::Texture& target,
                   const Kernel& kernel);

  gl::ProgramCache programs_;
  gl::Texture depth_, encoded_, half_, reduced_, levels_;
  SummedAreaTable sums_;
  int cascades_ = 1, samples_ = 1;
  std::vector<Channel> layout_;
  StorageFormat format_ = StorageFormat::Float;
  bool prefilterable_ = true;  // of the technique last encoded
  bool filtered_ = false;      // whether reduced_ holds the prefiltered channels
  bool levelled_ = false;      // whether levels_ holds their mip levels
  bool summed_ = false;        // whether sums_ holds their sums, in
  SatPrecision sumPrecision_ = SatPrecision::Centred;
};

}  // namespace umbra
