// A 2D texture with several samples a texel, at the same places in each.
#pragma once

#include "filters/gpu/gl/Handle.h"

namespace umbra::gl {

class MultisampleTexture {
 public:
  MultisampleTexture() = default;

  // Makes the texture anew unless it has these properties already. `samples` is a number that the
  // driver has for this format.
  void require(GLenum internalFormat, int width, int height, int samples) {
    if (handle_ && format_ == internalFormat && width_ == width && height_ == height &&
        samples_ == samples)
      return;
    handle_.reset();  // first: two large ones at once may not fit
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &name);
    handle_ = TextureHandle(name);
    glTextureStorage2DMultisample(name, samples, internalFormat, width, height, GL_TRUE);
    format_ = internalFormat;
    width_ = width;
    height_ = height;
    samples_ = samples;
  }

  void reset() { handle_.reset(); }
  GLuint name() const { return handle_.name(); }

 private:
  TextureHandle handle_;
  GLenum format_ = 0;
  int width_ = 0, height_ = 0, samples_ = 0;
};

}  // namespace umbra::gl
