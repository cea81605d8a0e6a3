// Makes a technique's prefiltered channels from depth maps, both on the GPU.
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

// The bytes that the textures of a square map with these settings take on the GPU: the depth, the
// encoded channels and, where there is something to prefilter, the reduced channels and those
// between the two axes, as well as mip levels or a summed-area table where the filter reads them.
// More channels than two fill whole layers of four.
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
  // Replaces the depths of a cascade for which there is room. A map of another size or with another
  // number of samples gets new room.
  void uploadDepth(const DepthMap& map, int cascade = 0);
  DepthMap readDepth(int cascade = 0) const;

  // Encodes every texel into `format` (any but Double).
  void encode(Technique& technique, StorageFormat format);
  // Reduces over the kernel what `encode` left. Values are 32-bit between the axes and `format` at
  // the end. The cost per texel does not grow with the radius of a box. Where the kernel is empty
  // or the technique reads raw texels, the encoded channels serve as the prefiltered ones.
  void prefilter(const Kernel& kernel);
  // Builds the mip levels of what `prefilter` left, each rounded to the format.
  void buildLevels();
  // Whether the levels are still to be built; a technique that reads raw texels has none.
  bool needsLevels() const { return prefilterable_ && !levelled_; }

  // Builds the summed-area table of what `prefilter` left.
  void buildSums(SatPrecision precision);
  // Whether the table is still to be built; a technique that reads raw texels has none.
  bool needsSums(SatPrecision precision) const {
    return prefilterable_ && !(summed_ && sumPrecision_ == precision);
  }

  // The channels that the shaded frame reads. Layer: cascade * layersFor(channels) + layer of the
  // channels.
  const gl::Texture& channelMap() const { return stage(BakeStage::Prefiltered); }
  // Mip levels 1 and on. With P the next power of two of the map's longer side, mip level L has P
  // >> L texels a side. The texture is empty before they are built.
  const gl::Texture& levelMap() const { return levels_; }
  // The table in the layout of SummedAreaTable. It is empty before it is built.
  const gl::Texture& sumMap() const { return sums_.texture(); }
  // Channels interleaved, as values and not as stored fractions.
  Image<float> read(BakeStage stage, int cascade = 0) const;
  Image<float> readLevel(int level, int cascade = 0) const;  // levels 1 and on
  // Takes `channels` for the stage: the tests feed each stage with the reference's last one.
  void upload(BakeStage stage, const Image<float>& channels, int cascade = 0);

  // Evaluates for each pixel (u, v, z_r, ·) of `surfaces` the visibility and exact
  // percentage-closer filtering; both are 1 where (u, v) is outside [0,1]. The result has two
  // floats a pixel in the row order of `surfaces`. `footprints` (x, y, probes, cascade + weight of
  // the next one) may be null unless reads.needFootprints(). The numbers of cascades and samples
  // are those of the prepared depths.
  std::vector<float> evaluate(const gl::Texture& surfaces, const gl::Texture* footprints,
                              Technique& technique, MapReads reads);

  void releaseGraphicsResources();

 private:
  const gl::Texture& stage(BakeStage stage) const;
  int channelLayers() const { return layersFor(int(layout_.size())); }
  std::vector<float> signs() const;  // signs for Reduce.glsl
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
