#include "filters/gpu/gl/Program.h"

#include "filters/core/support/Error.h"

namespace umbra::gl {
namespace {

[[noreturn]] void fail(std::string_view what, std::string log) {
  log.resize(std::min(log.find('\n'), log.size()));
  throw Error(ErrorKind::WorkFailed, "shader " + std::string(what) + ": " + log);
}

ShaderHandle compile(std::string_view what, GLenum stage, const std::string& source) {
  ShaderHandle shader(glCreateShader(stage));
  const char* text = source.c_str();
  glShaderSource(shader.name(), 1, &text, nullptr);
  glCompileShader(shader.name());
  GLint done = 0;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &done);
  if (!done) {
    char log[2048] = "";
    glGetShaderInfoLog(shader.name(), sizeof log, nullptr, log);
    fail(what, log);
  }
  return shader;
}

ProgramHandle link(std::string_view what, std::span<const ShaderHandle> shaders) {
  ProgramHandle program(glCreateProgram());
  for (const ShaderHandle& shader : shaders) glAttachShader(program.name(), shader.name());
  glLinkProgram(program.name());
  for (const ShaderHandle& shader : shaders) glDetachShader(program.name(), shader.name());
  GLint done = 0;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &done);
  if (!done) {
    char log[2048] = "";
    glGetProgramInfoLog(program.name(), sizeof log, nullptr, log);
    fail(what, log);
  }
  return program;
}

}  // namespace

ProgramHandle compileCompute(std::string_view what, const std::string& source) {
  const ShaderHandle shaders[] = {compile(what, GL_COMPUTE_SHADER, source)};
  return link(what, shaders);
}

ProgramHandle compileScreen(std::string_view what, const std::string& vertex,
                            const std::string& fragment) {
  const ShaderHandle shaders[] = {compile(what, GL_VERTEX_SHADER, vertex),
                                  compile(what, GL_FRAGMENT_SHADER, fragment)};
  return link(what, shaders);
}

GLuint ProgramCache::compute(std::string_view what, const std::string& source) {
  ProgramHandle& program = programs_[source];
  if (!program) program = compileCompute(what, source);
  return program.name();
}

GLuint ProgramCache::screen(std::string_view what, const std::string& vertex,
                            const std::string& fragment) {
  ProgramHandle& program = programs_[vertex + fragment];
  if (!program) program = compileScreen(what, vertex, fragment);
  return program.name();
}

void setUniform(GLuint program, const char* name, int value) {
  glProgramUniform1i(program, glGetUniformLocation(program, name), value);
}

void setUniform(GLuint program, const char* name, float value) {
  glProgramUniform1f(program, glGetUniformLocation(program, name), value);
}

void setUniform(GLuint program, const char* name, int x, int y) {
  glProgramUniform2i(program, glGetUniformLocation(program, name), x, y);
}

void setUniform(GLuint program, const char* name, std::span<const float> values) {
  glProgramUniform1fv(program, glGetUniformLocation(program, name), GLsizei(values.size()),
                      values.data());
}

void setUniform3(GLuint program, const char* name, std::span<const float> values) {
  glProgramUniform3fv(program, glGetUniformLocation(program, name), GLsizei(values.size() / 3),
                      values.data());
}

void setUniform4(GLuint program, const char* name, std::span<const float> values) {
  glProgramUniform4fv(program, glGetUniformLocation(program, name), GLsizei(values.size() / 4),
                      values.data());
}

void setUniformMatrix4(GLuint program, const char* name, const float* columns) {
  glProgramUniformMatrix4fv(program, glGetUniformLocation(program, name), 1, GL_FALSE, columns);
}

}  // namespace umbra::gl
