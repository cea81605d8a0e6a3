#include "filters/gpu/gl/PassTimer.h"

#include "filters/core/support/ProcessorTime.h"

namespace umbra::gl {

void PassTimer::begin(std::string pass) {
  if (used_ == entries_.size()) {
    GLuint name = 0;
    glCreateQueries(GL_TIME_ELAPSED, 1, &name);
    entries_.push_back({{}, QueryHandle(name)});
  }
  Entry& entry = entries_[used_++];
  entry.pass = std::move(pass);
  if (clock_ == PassClock::Gpu) {
    glBeginQuery(GL_TIME_ELAPSED, entry.query.name());
    return;
  }
  glFinish();
  entry.milliseconds = processorMilliseconds();
}

void PassTimer::end() {
  if (clock_ == PassClock::Gpu) {
    glEndQuery(GL_TIME_ELAPSED);
    return;
  }
  glFinish();
  Entry& entry = entries_[used_ - 1];
  entry.milliseconds = processorMilliseconds() - entry.milliseconds;
}

std::vector<PassTimer::Time> PassTimer::times() const {
  std::vector<Time> times;
  for (std::size_t i = 0; i < used_; ++i) {
    const Entry& entry = entries_[i];
    double milliseconds = entry.milliseconds;
    if (clock_ == PassClock::Gpu) {
      GLuint64 nanoseconds = 0;
      glGetQueryObjectui64v(entry.query.name(), GL_QUERY_RESULT, &nanoseconds);
      milliseconds = double(nanoseconds) * 1e-6;
    }
    times.push_back({entry.pass, milliseconds});
  }
  return times;
}

void PassTimer::clear() {
  entries_.clear();
  used_ = 0;
}

}  // namespace umbra::gl
