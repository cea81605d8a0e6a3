#include "filters/gpu/bench/CostClock.h"

#include "filters/core/support/ProcessorTime.h"
#include "filters/gpu/gl/OpenGL.h"

namespace umbra {
namespace {

gl::QueryHandle markedTime() {
  GLuint name = 0;
  glCreateQueries(GL_TIMESTAMP, 1, &name);
  return gl::QueryHandle(name);
}

GLuint64 nanosecondsOf(const gl::QueryHandle& mark) {
  GLuint64 time = 0;
  glGetQueryObjectui64v(mark.name(), GL_QUERY_RESULT, &time);
  return time;
}

}  // namespace

std::string nameOfRenderer() {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name ? reinterpret_cast<const char*>(name) : "";
}

bool drawsInSoftware() {
  const std::string name = nameOfRenderer();
  for (const char* software : {"llvmpipe", "softpipe", "SWR", "SwiftShader", "Software Rasterizer"})
    if (name.find(software) != std::string::npos) return true;
  return false;
}

double CostMeter::millisecondsOf(const std::function<void()>& draw) {
  glFinish();  // nothing of the frame before is left to be drawn
  if (clock_ == CostClock::Processor) {
    const double before = processorMilliseconds();
    draw();
    glFinish();
    return processorMilliseconds() - before;
  }
  if (!begin_) {
    begin_ = markedTime();
    end_ = markedTime();
  }
  glQueryCounter(begin_.name(), GL_TIMESTAMP);
  draw();
  glQueryCounter(end_.name(), GL_TIMESTAMP);
  return double(nanosecondsOf(end_) - nanosecondsOf(begin_)) * 1e-6;
}

}  // namespace umbra
