#include "filters/gpu/gl/Texture.h"

#include <algorithm>

namespace umbra::gl {
namespace {

GLenum transferFormat(int components) {
  static constexpr GLenum formats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  return formats[components - 1];
}

}  // namespace

Texture::Texture(GLenum internalFormat, int width, int height, int layers, int levels)
    : format_(internalFormat), width_(width), height_(height), layers_(layers), levels_(levels) {
  GLuint name = 0;
  glCreateTextures(layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &name);
  handle_ = TextureHandle(name);
  if (layers > 0)
    glTextureStorage3D(name, levels, internalFormat, width, height, layers);
  else
    glTextureStorage2D(name, levels, internalFormat, width, height);
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void Texture::require(GLenum internalFormat, int width, int height, int layers, int levels) {
  if (handle_ && format_ == internalFormat && width_ == width && height_ == height &&
      layers_ == layers && levels_ == levels)
    return;
  // Free first: two large arrays at once may not fit.
  handle_.reset();
  *this = Texture(internalFormat, width, height, layers, levels);
}

std::vector<float> Texture::read(int components) const {
  return readLayers(components, 0, std::max(layers_, 1));
}

void Texture::upload(int components, const std::vector<float>& values) {
  const GLenum format = transferFormat(components);
  if (layers_ > 0)
    glTextureSubImage3D(name(), 0, 0, 0, 0, width_, height_, layers_, format, GL_FLOAT,
                        values.data());
  else
    glTextureSubImage2D(name(), 0, 0, 0, width_, height_, format, GL_FLOAT, values.data());
}

std::vector<float> Texture::readLayers(int components, int first, int count, int level) const {
  const int width = std::max(width_ >> level, 1), height = std::max(height_ >> level, 1);
  const std::size_t layer = std::size_t(width) * height * components;
  std::vector<float> values(layer * count);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  // One by one: OpenGL counts the bytes of a read in 31 bits.
  for (int i = 0; i < count; ++i)
    glGetTextureSubImage(name(), level, 0, 0, first + i, width, height, 1,
                         transferFormat(components), GL_FLOAT, GLsizei(layer * sizeof(float)),
                         values.data() + std::size_t(i) * layer);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  return values;
}

void Texture::uploadLayers(int components, int first, int count, const std::vector<float>& values) {
  glTextureSubImage3D(name(), 0, 0, 0, first, width_, height_, count, transferFormat(components),
                      GL_FLOAT, values.data());
}

GLenum depthFormatOf(GLuint framebuffer) {
  GLint type = GL_NONE, texture = 0, format = GL_NONE;
  if (framebuffer == 0) return GL_NONE;
  glGetNamedFramebufferAttachmentParameteriv(framebuffer, GL_DEPTH_ATTACHMENT,
                                             GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  if (type != GL_TEXTURE) return GL_NONE;
  glGetNamedFramebufferAttachmentParameteriv(framebuffer, GL_DEPTH_ATTACHMENT,
                                             GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &texture);
  glGetTextureLevelParameteriv(GLuint(texture), 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
  return GLenum(format);
}

Image<float> flipped(int width, int height, int channels, const std::vector<float>& values) {
  Image<float> image(width, height, channels);
  const std::size_t row = std::size_t(width) * channels;
  for (int y = 0; y < height; ++y)
    std::copy_n(values.begin() + std::size_t(height - 1 - y) * row, row,
                image.values().begin() + std::size_t(y) * row);
  return image;
}

}  // namespace umbra::gl
