#include "filters/gpu/ChannelBaker.h"

#include "BlockReduce_comp_glsl.h"
#include "Encode_comp_glsl.h"
#include "Evaluate_comp_glsl.h"
#include "Reduce_glsl.h"
#include "Store_glsl.h"
#include "WeightedReduce_comp_glsl.h"
#include "filters/core/Error.h"
#include "filters/gpu/TechniqueShader.h"

namespace umbra {
namespace {

// One and two channels need not carry the other two or three along.
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

// Of one texel of such textures, in all their layers.
std::size_t texelBytes(StorageFormat format, std::size_t channels) {
  const std::size_t stored = channels <= 2 ? channels : 4 * std::size_t(layersFor(int(channels)));
  switch (format) {
    case StorageFormat::Unorm8:
      return stored;
    case StorageFormat::Unorm16:
    case StorageFormat::Half:
      return 2 * stored;
    case StorageFormat::Float:
      return 4 * stored;
    case StorageFormat::Double:
      break;
  }
  return 0;  // as textureFormat: no texture holds it
}

GLuint groups(int items, int groupSize) {
  return GLuint((items + groupSize - 1) / groupSize);
}

// Store.glsl for this target. What is settled when a shader is compiled costs nothing later: a
// software renderer executes both sides of a branch.
std::string storeSource(const gl::Texture& target) {
  const GLenum format = target.format();
  const bool half = format == GL_R16F || format == GL_RG16F || format == GL_RGBA16F;
  return std::string("#define UMBRA_HALF ") + (half ? "1\n" : "0\n") + Store_glsl;
}

void bindTarget(const gl::Texture& target) {
  glBindImageTexture(0, target.name(), 0, GL_TRUE, 0, GL_WRITE_ONLY, target.format());
}

// Until the results may be sampled, read back and written again.
void finish() {
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                  GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  glUseProgram(0);
}

// Units that VTK does not hold on to between its draws.
constexpr int depthUnit = 0, channelUnit = 1, readUnit = 2;

float reductionSign(Reduction reduction) {
  return reduction == Reduction::Mean ? 0.0f : reduction == Reduction::Max ? 1.0f : -1.0f;
}

}  // namespace

std::size_t textureBytes(const FrameSettings& settings, const Technique& technique) {
  const std::size_t channels = technique.channels().size();
  const std::size_t encoded = texelBytes(settings.map.format, channels);
  std::size_t bytes = texelBytes(StorageFormat::Float, 1) + encoded;
  if (technique.info().prefilterable && settings.kernel.effectiveRadius() > 0)
    bytes += texelBytes(StorageFormat::Float, channels) + encoded;
  return bytes * std::size_t(settings.map.size) * std::size_t(settings.map.size);
}

void ChannelBaker::uploadDepth(const DepthMap& map) {
  depth_.require(GL_R32F, map.width(), map.height());
  depth_.upload(1, std::vector<float>(map.values().begin(), map.values().end()));
}

void ChannelBaker::encode(Technique& technique, StorageFormat format) {
  if (format == StorageFormat::Double)
    throw Error(ErrorKind::BadCommandLine,
                "format: double is not stored on the GPU; unorm8, unorm16, half and float are");
  layout_ = technique.channels();
  format_ = format;
  prefilterable_ = technique.info().prefilterable;
  filtered_ = false;
  encoded_.require(textureFormat(format, layout_.size()), depth_.width(), depth_.height(),
                   layersFor(int(layout_.size())));
  const std::string name = "encode of " + std::string(technique.info().id);
  const GLuint program =
      programs_.compute(name, computeSource(technique, storeSource(encoded_) + Encode_comp_glsl));
  setTechniqueUniforms(program, technique, format);
  gl::setUniform(program, "umbraDepthMap", depthUnit);
  gl::setUniform(program, "umbraChannelMap", channelUnit);
  glUseProgram(program);
  glBindTextureUnit(depthUnit, depth_.name());
  bindTarget(encoded_);
  glDispatchCompute(groups(depth_.width(), 8), groups(depth_.height(), 8), 1);
  finish();
}

void ChannelBaker::prefilter(const Kernel& kernel) {
  filtered_ = prefilterable_ && kernel.effectiveRadius() > 0;
  if (!filtered_) return;
  const int width = encoded_.width(), height = encoded_.height(), layers = encoded_.layers();
  half_.require(textureFormat(StorageFormat::Float, layout_.size()), width, height, layers);
  reduced_.require(encoded_.format(), width, height, layers);
  reduceAlong(1, 0, encoded_, half_, kernel);
  reduceAlong(0, 1, half_, reduced_, kernel);
}

void ChannelBaker::reduceAlong(int x, int y, const gl::Texture& source, const gl::Texture& target,
                               const Kernel& kernel) {
  const bool box = kernel.shape == KernelShape::Box;
  const std::string text = "#version 430\n#define UMBRA_LAYERS " + std::to_string(source.layers()) +
                           "\n" + storeSource(target) + Reduce_glsl +
                           (box ? BlockReduce_comp_glsl : WeightedReduce_comp_glsl);
  const GLuint program = programs_.compute(box ? "box reduction" : "weighted reduction", text);
  std::vector<float> signs(std::size_t(source.layers()) * 4, 0.0f);
  for (std::size_t c = 0; c < layout_.size(); ++c) signs[c] = reductionSign(layout_[c].reduction);
  gl::setUniform4(program, "umbraSigns", signs);
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

Image<float> ChannelBaker::read(BakeStage which) const {
  const gl::Texture& texture = stage(which);
  const int width = texture.width(), height = texture.height();
  const std::vector<float> texels = texture.read(4);
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

void ChannelBaker::upload(BakeStage which, const Image<float>& channels) {
  const int width = encoded_.width(), height = encoded_.height();
  std::vector<float> texels(std::size_t(width) * height * encoded_.layers() * 4, 0.0f);
  for (std::size_t c = 0; c < layout_.size(); ++c) {
    const ChannelRange range = rangeOf(layout_[c], format_);
    float* layer = texels.data() + (c / 4) * std::size_t(width) * height * 4 + c % 4;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        layer[(std::size_t(y) * width + x) * 4] = (channels(x, y, int(c)) - range.low) / range.span;
  }
  if (which == BakeStage::Prefiltered) {
    reduced_.require(encoded_.format(), width, height, encoded_.layers());
    filtered_ = true;
    reduced_.upload(4, texels);
  } else {
    encoded_.upload(4, texels);
  }
}

std::vector<float> ChannelBaker::evaluate(const gl::Texture& reads, Technique& technique,
                                          const Kernel& kernel, ReadFilter read) {
  const gl::Texture result(GL_RG32F, reads.width(), reads.height());
  const std::string name = "visibility of " + std::string(technique.info().id);
  const GLuint program = programs_.compute(name, computeSource(technique, Evaluate_comp_glsl));
  setTechniqueUniforms(program, technique, format_);
  setReadUniforms(program, kernel, read);
  gl::setUniform(program, "umbraDepthMap", depthUnit);
  gl::setUniform(program, "umbraChannelMap", channelUnit);
  gl::setUniform(program, "umbraReads", readUnit);
  glUseProgram(program);
  glBindTextureUnit(depthUnit, depth_.name());
  glBindTextureUnit(channelUnit, channelMap().name());
  glBindTextureUnit(readUnit, reads.name());
  bindTarget(result);
  glDispatchCompute(groups(reads.width(), 8), groups(reads.height(), 8), 1);
  finish();
  return result.read(2);
}

void ChannelBaker::releaseGraphicsResources() {
  programs_.clear();
  for (gl::Texture* texture : {&depth_, &encoded_, &half_, &reduced_}) *texture = gl::Texture();
  filtered_ = false;
}

}  // namespace umbra
