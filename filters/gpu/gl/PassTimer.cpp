#include "filters/gpu/gl/PassTimer.h"

namespace umbra::gl {

void PassTimer::begin(std::string pass) {
  if (used_ == entries_.size()) {
    GLuint name = 0;
    glCreateQueries(GL_TIME_ELAPSED, 1, &name);
    entries_.push_back({{}, QueryHandle(name)});
  }
  entries_[used_].pass = std::move(pass);
  glBeginQuery(GL_TIME_ELAPSED, entries_[used_].query.name());
  ++used_;
}

std::vector<PassTimer::Time> PassTimer::times() const {
  std::vector<Time> times;
  for (std::size_t i = 0; i < used_; ++i) {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(entries_[i].query.name(), GL_QUERY_RESULT, &nanoseconds);
    times.push_back({entries_[i].pass, double(nanoseconds) * 1e-6});
  }
  return times;
}

void PassTimer::clear() {
  entries_.clear();
  used_ = 0;
}

}  // namespace umbra::gl
