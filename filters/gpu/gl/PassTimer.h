// The time of the passes of one frame.
#pragma once

#include <string>
#include <vector>

#include "filters/gpu/gl/Handle.h"
#include "filters/gpu/gl/PassClock.h"

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
    Scope(PassTimer& timer, std::string pass) : timer_(timer) { timer_.begin(std::move(pass)); }
    ~Scope() { timer_.end(); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    PassTimer& timer_;
  };

  // Counts for the frames that start from now on. The default is Gpu.
  void setClock(PassClock clock) { wanted_ = clock; }
  void startFrame() {
    used_ = 0;
    clock_ = wanted_;
  }
  std::vector<Time> times() const;
  void clear();

 private:
  struct Entry {
    std::string pass;
    QueryHandle query;
    double milliseconds = 0.0;  // of the processor; while the pass runs, when it began
  };
  void begin(std::string pass);
  void end();

  std::vector<Entry> entries_;  // grows to the most passes that a frame had
  std::size_t used_ = 0;
  PassClock wanted_ = PassClock::Gpu, clock_ = PassClock::Gpu;
};

}  // namespace umbra::gl
