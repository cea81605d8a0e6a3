// Owners of raw OpenGL objects. Their context must be current when they are made and freed.
#pragma once

#include <utility>

#include "filters/gpu/gl/OpenGL.h"

namespace umbra::gl {

// Move-only; 0 owns nothing.
template <void (*destroy)(GLuint)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint name) : name_(name) {}
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Handle() { reset(); }

  void reset() {
    if (name_ != 0) destroy(std::exchange(name_, 0));
  }
  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  GLuint name_ = 0;
};

// GLEW's entry points are variables, so that templates cannot take them themselves.
inline void destroyTexture(GLuint name) {
  glDeleteTextures(1, &name);
}
inline void destroyBuffer(GLuint name) {
  glDeleteBuffers(1, &name);
}
inline void destroyFramebuffer(GLuint name) {
  glDeleteFramebuffers(1, &name);
}
inline void destroyVertexArray(GLuint name) {
  glDeleteVertexArrays(1, &name);
}
inline void destroyQuery(GLuint name) {
  glDeleteQueries(1, &name);
}
inline void destroyProgram(GLuint name) {
  glDeleteProgram(name);
}
inline void destroyShader(GLuint name) {
  glDeleteShader(name);
}

using BufferHandle = Handle<destroyBuffer>;
using FramebufferHandle = Handle<destroyFramebuffer>;
using VertexArrayHandle = Handle<destroyVertexArray>;
using QueryHandle = Handle<destroyQuery>;
using ProgramHandle = Handle<destroyProgram>;
using ShaderHandle = Handle<destroyShader>;
using TextureHandle = Handle<destroyTexture>;

}  // namespace umbra::gl
