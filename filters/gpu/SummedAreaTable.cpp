#include "filters/gpu/SummedAreaTable.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "SatCentres_comp_glsl.h"
#include "SatSums_comp_glsl.h"
#include "filters/gpu/TechniqueShader.h"

namespace umbra {
namespace {

constexpr int sourceUnit = 0, centreUnit = 1;
// The terms that one pass adds up. More passes of two terms would cost more memory traffic than
// they save sums.
constexpr int terms = 4;

// A format with as many components as `channels`.
GLenum tableFormat(const gl::Texture& channels) {
  switch (channels.format()) {
    case GL_R8:
    case GL_R16:
    case GL_R16F:
    case GL_R32F:
      return GL_R32UI;
    case GL_RG8:
    case GL_RG16:
    case GL_RG16F:
    case GL_RG32F:
      return GL_RG32UI;
    default:
      return GL_RGBA32UI;
  }
}

void dispatch(GLuint program, const gl::Texture& target, GLuint groupsX, GLuint groupsY) {
  glUseProgram(program);
  glBindImageTexture(0, target.name(), 0, GL_TRUE, 0, GL_WRITE_ONLY, target.format());
  glDispatchCompute(groupsX, groupsY, GLuint(target.layers()));
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
  glUseProgram(0);
}

}  // namespace

int satPrecisionNumber(SatPrecision precision) {
  switch (precision) {
    case SatPrecision::Centred:
      return 0;
    case SatPrecision::Integer:
      return 1;
    case SatPrecision::Plain:
      return 2;
  }
  return 0;
}

void SummedAreaTable::build(const gl::Texture& channels, SatPrecision precision,
                            std::span<const ChannelRange> ranges) {
  const GLenum format = tableFormat(channels);
  const int width = channels.width(), height = channels.height(), layers = channels.layers();
  table_.require(format, width + 1, height + 2, layers);
  scratch_.require(format, width + 1, height + 2, layers);
  if (precision == SatPrecision::Centred) findCentres(channels, format);
  bool first = true;
  for (int step = 1; first || step < width; step *= terms) {
    addUp(channels, precision, ranges, first, step, 0);
    first = false;
  }
  for (int step = 1; step < height; step *= terms)
    addUp(channels, precision, ranges, false, 0, step);
  if (precision == SatPrecision::Centred)
    glCopyImageSubData(centres_.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, table_.name(),
                       GL_TEXTURE_2D_ARRAY, 0, 0, height + 1, 0, 1, 1, layers);
}

void SummedAreaTable::findCentres(const gl::Texture& channels, GLenum format) {
  centres_.require(format, 1, 1, channels.layers());
  const GLuint program = programs_.compute("centres of a table", SatCentres_comp_glsl);
  gl::setUniform(program, "umbraChannels", sourceUnit);
  glBindTextureUnit(sourceUnit, channels.name());
  dispatch(program, centres_, 1, 1);
}

void SummedAreaTable::addUp(const gl::Texture& channels, SatPrecision precision,
                            std::span<const ChannelRange> ranges, bool first, int stepX,
                            int stepY) {
  const auto define = [](const char* name, int value) {
    return std::string("#define UMBRA_") + name + " " + std::to_string(value) + "\n";
  };
  const int layersOfMap = layersFor(int(ranges.size()));
  const GLuint program = programs_.compute(
      "sums of a table", "#version 430\n" + define("LAYERS", layersOfMap) + define("FIRST", first) +
                             define("TERMS", terms) +
                             define("SAT_PRECISION", satPrecisionNumber(precision)) +
                             SatSums_comp_glsl);
  std::vector<float> low(std::size_t(layersOfMap) * 4, 0.0f), span(low.size(), 1.0f);
  for (std::size_t c = 0; c < ranges.size(); ++c) {
    low[c] = ranges[c].low;
    span[c] = ranges[c].span;
  }
  gl::setUniform4(program, "umbraLow", low);
  gl::setUniform4(program, "umbraSpan", span);
  gl::setUniform(program, "umbraStep", stepX, stepY);
  gl::setUniform(program, first ? "umbraChannels" : "umbraSource", sourceUnit);
  gl::setUniform(program, "umbraCentres", centreUnit);
  glBindTextureUnit(sourceUnit, first ? channels.name() : table_.name());
  glBindTextureUnit(centreUnit, centres_.name());
  dispatch(program, scratch_, GLuint(table_.width() + 7) / 8, GLuint(table_.height() + 6) / 8);
  std::swap(table_, scratch_);
}

std::size_t SummedAreaTable::bytes(std::size_t texelBytes, int size) {
  return 2 * texelBytes * std::size_t(size + 1) * std::size_t(size + 2);
}

void SummedAreaTable::releaseGraphicsResources() {
  programs_.clear();
  for (gl::Texture* texture : {&table_, &scratch_, &centres_}) *texture = gl::Texture();
}

}  // namespace umbra
