// Shader programs of our own (VTK's mappers build theirs), and uniforms of either.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "filters/gpu/gl/Handle.h"

namespace umbra::gl {

// Both throw WorkFailed with the first line of the compiler's log and `what`, the program's name.
ProgramHandle compileCompute(std::string_view what, const std::string& source);
ProgramHandle compileScreen(std::string_view what, const std::string& vertex,
                            const std::string& fragment);

// Compiled programs by their source, so that a return to a technique compiles nothing.
class ProgramCache {
 public:
  GLuint compute(std::string_view what, const std::string& source);
  GLuint screen(std::string_view what, const std::string& vertex, const std::string& fragment);
  void clear() { programs_.clear(); }

 private:
  std::unordered_map<std::string, ProgramHandle> programs_;
};

// Set a uniform of a linked program, bound or not. A name that the program does not use is
// ignored, since compilers drop what does not matter.
void setUniform(GLuint program, const char* name, int value);
void setUniform(GLuint program, const char* name, float value);
void setUniform(GLuint program, const char* name, int x, int y);
void setUniform(GLuint program, const char* name, std::span<const float> values);
void setUniform3(GLuint program, const char* name, std::span<const float> values);
void setUniform4(GLuint program, const char* name, std::span<const float> values);
// `matrix` is column-major, as Eigen keeps it.
void setUniformMatrix4(GLuint program, const char* name, const float* columns);

}  // namespace umbra::gl
