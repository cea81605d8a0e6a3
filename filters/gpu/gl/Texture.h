// Textures of fixed storage, made and read without touching any binding (OpenGL 4.5).
#pragma once

#include <vector>

#include "filters/core/maps/Image.h"
#include "filters/gpu/gl/Handle.h"

namespace umbra::gl {

// A 2D texture, or an array of them.
class Texture {
 public:
  Texture() = default;
  // `layers` 0 makes a plain 2D texture; each of `levels` has half the size of the one before.
  // Sampled by texelFetch only: nearest.
  Texture(GLenum internalFormat, int width, int height, int layers = 0, int levels = 1);

  // Makes the texture anew unless it has these properties already.
  void require(GLenum internalFormat, int width, int height, int layers = 0, int levels = 1);

  GLuint name() const { return handle_.name(); }
  int width() const { return width_; }
  int height() const { return height_; }
  int layers() const { return layers_; }
  int levels() const { return levels_; }
  GLenum format() const { return format_; }
  explicit operator bool() const { return bool(handle_); }

  // `components` floats a texel, in the texture's own row order; the layers of an array follow each
  // other.
  std::vector<float> read(int components) const;
  void upload(int components, const std::vector<float>& values);
  // The same for some layers of an array, and for one of its levels.
  std::vector<float> readLayers(int components, int first, int count, int level = 0) const;
  void uploadLayers(int components, int first, int count, const std::vector<float>& values);

 private:
  TextureHandle handle_;
  GLenum format_ = 0;
  int width_ = 0, height_ = 0, layers_ = 0, levels_ = 1;
};

// Internal format of a framebuffer's depth texture; GL_NONE where it has none.
GLenum depthFormatOf(GLuint framebuffer);

// Rows in the opposite order: OpenGL's pictures have their bottom row first.
Image<float> flipped(int width, int height, int channels, const std::vector<float>& values);

}  // namespace umbra::gl
