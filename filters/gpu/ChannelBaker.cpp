#include "filters/gpu/ChannelBaker.h"

#include "BlockReduce_comp_glsl.h"
#include "Encode_comp_glsl.h"
#include "Evaluate_comp_glsl.h"
#include "MipLevel_comp_glsl.h"
#include "Reduce_glsl.h"
#include "Store_glsl.h"
#include "Surface_glsl.h"
#include "WeightedReduce_comp_glsl.h"
#include "filters/core/maps/MipLevels.h"
#include "filters/core/support/Error.h"
#include "filters/gpu/gl/DrawOrder.h"

namespace umbra {
namespace {

// Textures of one or two channels hold no more components than that; larger ones hold four a layer.
constexpr GLenum textureFormat(StorageFormat format, std::size_t channels) {
  const auto choose = [&](GLenum one, GLenum two, GLenum four) {
    return channels == 1 ? one : channels == 2 ? two : four;
  };
  switch (format) {
    case StorageFormat::Unorm8:
      return choose(GL_R8, GL_RG8, GL_RGBA8);
    case StorageFormat::Unorm16:
      return choose(GL_R16, GL_RG16, GL_RGBA16);
    case StorageFormat::Half:
      return choose(GL_R16F, GL_RG16F, GL_RGBA16F);
    case StorageFormat::Float:
      return choose(GL_R32F, GL_RG32F, GL_RGBA32F);
    case StorageFormat::Double:
      break;
  }
  return GL_NONE;
}

// The bytes of one texel of such textures, in all their layers.
std::size_t texelBytes(StorageFormat format, std::size_t channels) {
  const std::size_t stored = channels <= 2 ? channels : 4 * std::size_t(layersFor(int(channels)));
  return stored * std::size_t(bytesOf(format));
}

GLuint groups(int items, int groupSize) {
  return GLuint((items + groupSize - 1) / groupSize);
}

// Store.glsl for this target. Conditions that are decided when a shader is compiled cost nothing
// later: a software renderer executes both sides of a branch.
std::string storeSource(const gl::Texture& target) {
  const GLenum format = target.format();
  const bool half = format == GL_R16F || format == GL_RG16F || format == GL_RGBA16F;
  const bool bytes = format == GL_R8 || format == GL_RG8 || format == GL_RGBA8;
  const bool words = format == GL_R16 || format == GL_RG16 || format == GL_RGBA16;
  return std::string("#define UMBRA_HALF ") + (half ? "1" : "0") + "\n#define UMBRA_STEPS " +
         (bytes   ? "255\n"
          : words ? "65535\n"
                  : "0\n") +
         Store_glsl;
}

void bindTarget(const gl::Texture& target, int level = 0) {
  glBindImageTexture(0, target.name(), level, GL_TRUE, 0, GL_WRITE_ONLY, target.format());
}

// Waits until the results may be sampled, read back and written again.
void finish() {
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                  GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  glUseProgram(0);
}

// VTK keeps no texture on these units between its draws.
constexpr int depthUnit = 0, channelUnit = 1;

float reductionSign(Reduction reduction) {
  return reduction == Reduction::Mean ? 0.0f : reduction == Reduction::Max ? 1.0f : -1.0f;
}

}  // namespace

std::size_t textureBytes(const FrameSettings& settings, const Technique& technique) {
  const std::size_t channels = technique.channels().size();
  const std::size_t encoded = texelBytes(settings.map.format, channels);
  const bool prefilterable = technique.info().prefilterable;
  const ReadFilter filter = settings.read.filter;
  std::size_t texel = texelBytes(StorageFormat::Float, 1) * settings.map.samples + encoded;
  if (prefilterable && settings.kernel.effectiveRadius() > 0 && filter != ReadFilter::SummedArea)
    texel += texelBytes(StorageFormat::Float, channels) + encoded;
  const auto size = std::size_t(settings.map.size);
  std::size_t bytes = texel * size * size;
  if (prefilterable && readsLevels(filter))
    for (int i = mipLevels(settings.map.size, settings.map.size) - 1; i >= 0; --i)
      bytes += encoded << (2 * i);
  if (prefilterable && filter == ReadFilter::SummedArea)
    bytes += SummedAreaTable::bytes(texelBytes(StorageFormat::Float, channels), settings.map.size);
  return bytes * settings.map.cascades.count;
}

void ChannelBaker::prepareDepth(int width, int height, int cascades, int samples) {
  cascades_ = cascades;
  samples_ = samples;
  depth_.require(GL_R32F, width, height, cascades * samples);
}

void ChannelBaker::uploadDepth(const DepthMap& map, int cascade) {
  if (depth_.width() != map.width() || depth_.height() != map.height() ||
      samples_ != map.channels() || cascade >= cascades_)
    prepareDepth(map.width(), map.height(), cascade + 1, map.channels());
  const std::size_t texels = std::size_t(map.width()) * map.height();
  std::vector<float> layers(texels * samples_);
  for (std::size_t i = 0; i < layers.size(); ++i)
    layers[i % samples_ * texels + i / samples_] = float(map.values()[i]);
  depth_.uploadLayers(1, cascade * samples_, samples_, layers);
}

DepthMap ChannelBaker::readDepth(int cascade) const {
  DepthMap map(depth_.width(), depth_.height(), samples_);
  const std::size_t texels = std::size_t(map.width()) * map.height();
  const std::vector<float> layers = depth_.readLayers(1, cascade * samples_, samples_);
  for (std::size_t i = 0; i < layers.size(); ++i)
    map.values()[i] = layers[i % samples_ * texels + i / samples_];
  return map;
}

void ChannelBaker::encode(Technique& technique, StorageFormat format) {
  if (format == StorageFormat::Double)
    throw Error(ErrorKind::BadCommandLine,
                "format: double is not stored on the GPU; unorm8, unorm16, half and float are");
  layout_ = technique.channels();
  format_ = format;
  prefilterable_ = technique.info().prefilterable;
  filtered_ = levelled_ = summed_ = false;
  encoded_.require(textureFormat(format, layout_.size()), depth_.width(), depth_.height(),
                   cascades_ * channelLayers());
  const std::string name = "encode of " + std::string(technique.info().id);
  MapReads reads;  // Reads have no influence on encoding; the defaults keep it one program.
  reads.samples = samples_;
  const GLuint program = programs_.compute(
      name, computeSource(technique, reads, storeSource(encoded_) + Encode_comp_glsl));
  setTechniqueUniforms(program, technique, format);
  gl::setUniform4(program, "umbraSigns", signs());
  gl::setUniform(program, "umbraDepthMap", depthUnit);
  gl::setUniform(program, "umbraChannelMap", channelUnit);
  glUseProgram(program);
  glBindTextureUnit(depthUnit, depth_.name());
  bindTarget(encoded_);
  glDispatchCompute(groups(depth_.width(), 8), groups(depth_.height(), 8), GLuint(cascades_));
  finish();
}

std::vector<float> ChannelBaker::signs() const {
  std::vector<float> signs(std::size_t(channelLayers()) * 4, 0.0f);
  for (std::size_t c = 0; c < layout_.size(); ++c) signs[c] = reductionSign(layout_[c].reduction);
  return signs;
}

std::string ChannelBaker::reductionSource(const gl::Texture& target) const {
  return "#version 430\n#define UMBRA_LAYERS " + std::to_string(channelLayers()) + "\n" +
         storeSource(target) + Reduce_glsl;
}

void ChannelBaker::prefilter(const Kernel& kernel) {
  levelled_ = summed_ = false;
  filtered_ = prefilterable_ && kernel.effectiveRadius() > 0;
  if (!filtered_) return;
  const int width = encoded_.width(), height = encoded_.height(), layers = encoded_.layers();
  half_.require(textureFormat(StorageFormat::Float, layout_.size()), width, height, layers);
  reduced_.require(encoded_.format(), width, height, layers);
  reduceAlong(1, 0, encoded_, half_, kernel);
  reduceAlong(0, 1, half_, reduced_, kernel);
}

void ChannelBaker::buildLevels() {
  const gl::Texture& map = channelMap();
  const int count = mipLevels(map.width(), map.height());
  const int side = 1 << (count - 1);  // of level 1
  levels_.require(map.format(), side, side, map.layers(), count);
  const GLuint program =
      programs_.compute("mip level", reductionSource(levels_) + MipLevel_comp_glsl);
  gl::setUniform4(program, "umbraSigns", signs());
  gl::setUniform(program, "umbraSource", channelUnit);
  for (int level = 0; level < count; ++level) {
    gl::setUniform(program, "umbraSourceLevel", std::max(level - 1, 0));
    glUseProgram(program);
    glBindTextureUnit(channelUnit, level == 0 ? map.name() : levels_.name());
    bindTarget(levels_, level);
    glDispatchCompute(groups(side >> level, 8), groups(side >> level, 8), GLuint(map.layers()));
    finish();
  }
  levelled_ = true;
}

void ChannelBaker::buildSums(SatPrecision precision) {
  std::vector<ChannelRange> ranges;
  for (const Channel& channel : layout_)  // a normalised format's texels are fractions already
    ranges.push_back(isNormalised(format_) ? ChannelRange()
                                           : rangeOf(channel, StorageFormat::Unorm16));
  sums_.build(channelMap(), precision, ranges);
  sumPrecision_ = precision;
  summed_ = true;
}

void ChannelBaker::reduceAlong(int x, int y, const gl::Texture& source, const gl::Texture& target,
                               const Kernel& kernel) {
  const bool box = kernel.shape == KernelShape::Box;
  const std::string text =
      reductionSource(target) + (box ? BlockReduce_comp_glsl : WeightedReduce_comp_glsl);
  const GLuint program = programs_.compute(box ? "box reduction" : "weighted reduction", text);
  gl::setUniform4(program, "umbraSigns", signs());
  gl::setUniform(program, "umbraAxis", x, y);
  gl::setUniform(program, "umbraRadius", kernel.effectiveRadius());
  gl::setUniform(program, "umbraSource", channelUnit);
  if (!box) gl::setUniform(program, "umbraWeights", halfWeights(kernel));
  glUseProgram(program);
  glBindTextureUnit(channelUnit, source.name());
  bindTarget(target);
  if (box) {
    const int lines = x ? source.height() : source.width();
    const int length = x ? source.width() : source.height();
    const int window = 2 * kernel.effectiveRadius() + 1;
    glDispatchCompute(groups(lines, 16), groups((length + window - 1) / window, 2),
                      source.layers());
  } else {
    glDispatchCompute(groups(source.width(), 8), groups(source.height(), 8), source.layers());
  }
  finish();
}

const gl::Texture& ChannelBaker::stage(BakeStage stage) const {
  return stage == BakeStage::Prefiltered && filtered_ ? reduced_ : encoded_;
}

Image<float> ChannelBaker::valuesOf(const std::vector<float>& texels, int width, int height) const {
  Image<float> channels(width, height, int(layout_.size()));
  for (std::size_t c = 0; c < layout_.size(); ++c) {
    const ChannelRange range = rangeOf(layout_[c], format_);
    const float* layer = texels.data() + (c / 4) * std::size_t(width) * height * 4 + c % 4;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        channels(x, y, int(c)) = range.low + range.span * layer[(std::size_t(y) * width + x) * 4];
  }
  return channels;
}

Image<float> ChannelBaker::read(BakeStage which, int cascade) const {
  const gl::Texture& texture = stage(which);
  return valuesOf(texture.readLayers(4, cascade * channelLayers(), channelLayers()),
                  texture.width(), texture.height());
}

Image<float> ChannelBaker::readLevel(int level, int cascade) const {
  const int side = levels_.width() >> (level - 1);
  return valuesOf(levels_.readLayers(4, cascade * channelLayers(), channelLayers(), level - 1),
                  side, side);
}

void ChannelBaker::upload(BakeStage which, const Image<float>& channels, int cascade) {
  const int width = encoded_.width(), height = encoded_.height();
  std::vector<float> texels(std::size_t(width) * height * channelLayers() * 4, 0.0f);
  for (std::size_t c = 0; c < layout_.size(); ++c) {
    const ChannelRange range = rangeOf(layout_[c], format_);
    float* layer = texels.data() + (c / 4) * std::size_t(width) * height * 4 + c % 4;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        layer[(std::size_t(y) * width + x) * 4] = (channels(x, y, int(c)) - range.low) / range.span;
  }
  levelled_ = summed_ = false;
  if (which == BakeStage::Prefiltered) {
    reduced_.require(encoded_.format(), width, height, encoded_.layers());
    filtered_ = true;
  }
  gl::Texture& target = which == BakeStage::Prefiltered ? reduced_ : encoded_;
  target.uploadLayers(4, cascade * channelLayers(), channelLayers(), texels);
}

std::vector<float> ChannelBaker::evaluate(const gl::Texture& surfaces,
                                          const gl::Texture* footprints, Technique& technique,
                                          MapReads reads) {
  gl::finishDraws();  // of the surfaces
  reads.samples = samples_;
  reads.cascades = cascades_;
  const gl::Texture result(GL_RG32F, surfaces.width(), surfaces.height());
  const std::string name = "visibility of " + std::string(technique.info().id);
  const GLuint program = programs_.compute(
      name, computeSource(technique, reads, std::string(Surface_glsl) + Evaluate_comp_glsl));
  setTechniqueUniforms(program, technique, readFormat(format_, reads));
  setReadUniforms(program, reads);
  const std::pair<const char*, GLuint> textures[] = {
      {"umbraDepthMap", depth_.name()},
      {"umbraChannelMap", channelMap().name()},
      {"umbraReads", surfaces.name()},
      {"umbraMipMap", levelled_ ? levels_.name() : 0},
      {"umbraFootprints", footprints ? footprints->name() : 0},
      {"umbraSat", summed_ ? sums_.texture().name() : 0}};
  for (int unit = 0; unit < int(std::size(textures)); ++unit) {
    gl::setUniform(program, textures[unit].first, unit);
    glBindTextureUnit(GLuint(unit), textures[unit].second);
  }
  glUseProgram(program);
  bindTarget(result);
  glDispatchCompute(groups(surfaces.width(), 8), groups(surfaces.height(), 8), 1);
  finish();
  return result.read(2);
}

void ChannelBaker::releaseGraphicsResources() {
  programs_.clear();
  for (gl::Texture* texture : {&depth_, &encoded_, &half_, &reduced_, &levels_})
    *texture = gl::Texture();
  sums_.releaseGraphicsResources();
  filtered_ = levelled_ = summed_ = false;
}

}  // namespace umbra
