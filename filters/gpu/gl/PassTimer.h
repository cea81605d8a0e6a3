// GPU time of the passes of one frame. The frame never waits: only reading the times does.
#pragma once

#include <string>
#include <vector>

#include "filters/gpu/gl/Handle.h"

namespace umbra::gl {

class PassTimer {
 public:
  struct Time {
    std::string pass;
    double milliseconds = 0.0;
  };

  // Times what is drawn until it is destroyed; scopes do not nest.
  class Scope {
   public:
    Scope(PassTimer& timer, std::string pass) { timer.begin(std::move(pass)); }
    ~Scope() { glEndQuery(GL_TIME_ELAPSED); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
  };

  void startFrame() { used_ = 0; }
  std::vector<Time> times() const;
  void clear();

 private:
  struct Entry {
    std::string pass;
    QueryHandle query;
  };
  void begin(std::string pass);

  std::vector<Entry> entries_;  // grows to the most passes that a frame had
  std::size_t used_ = 0;
};

}  // namespace umbra::gl
