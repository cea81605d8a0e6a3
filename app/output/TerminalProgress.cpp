#include "app/output/TerminalProgress.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <memory>

#include "app/output/Cancellation.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using Clock = std::chrono::steady_clock;

// One line that is written over and over.
class TerminalLine {
 public:
  explicit TerminalLine(std::string name) : name_(std::move(name)) {}
  ~TerminalLine() {
    if (isShown_) std::fputs("\r\033[K", stderr);
  }
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  void show(double part) {
    const Clock::time_point now = Clock::now();
    if (!isTerminal_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    std::fprintf(stderr, "\rreading %s: %.0f %%\033[K", name_.c_str(), 100.0 * part);
    isShown_ = true;
  }

 private:
  const std::string name_;
  const bool isTerminal_ = isatty(STDERR_FILENO) != 0;
  bool isShown_ = false;
  Clock::time_point next_ = Clock::now() + std::chrono::milliseconds(400);
};

}  // namespace

Progress progressOnTerminal(const std::string& name) {
  const auto line = std::make_shared<TerminalLine>(clipped(name));
  return Progress([line](double part) {
    throwIfCancelled();
    line->show(part);
  });
}

}  // namespace umbra
