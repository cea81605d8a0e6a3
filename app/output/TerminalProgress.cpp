#include "app/output/TerminalProgress.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
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
  TerminalLine() = default;
  ~TerminalLine() {
    if (isShown_) std::fputs("\r\033[K", stderr);
  }
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  // Writes what `text` gives, where it is time for that.
  template <class Text>
  void show(const Text& text) {
    const Clock::time_point now = Clock::now();
    if (!isTerminal_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    std::fprintf(stderr, "\r%s\033[K", text().c_str());
    isShown_ = true;
  }

 private:
  const bool isTerminal_ = isatty(STDERR_FILENO) != 0;
  bool isShown_ = false;
  Clock::time_point next_ = Clock::now() + std::chrono::milliseconds(400);
};

}  // namespace

Progress progressOnTerminal(const std::string& name) {
  const auto line = std::make_shared<TerminalLine>();
  return Progress([line, shown = clipped(name)](double part) {
    throwIfCancelled();
    line->show(
        [&] { return "reading " + shown + ": " + std::to_string(int(100.0 * part)) + " %"; });
  });
}

Progress progressOfCells(std::size_t count, std::size_t done) {
  const auto line = std::make_shared<TerminalLine>();
  const Clock::time_point began = Clock::now();
  return Progress([line, count, done, began](double part) {
    throwIfCancelled();
    line->show([&] {
      const double measured = part * double(count) - double(done);
      const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
      std::string text = "cell " + std::to_string(std::lround(part * double(count)) + 1) + " of " +
                         std::to_string(count);
      if (measured >= 1.0) {
        const double left = seconds / measured * double(count) * (1.0 - part);
        text += left < 90.0 ? ", " + std::to_string(int(left) + 1) + " s left"
                            : ", " + std::to_string(std::lround(left / 60.0)) + " min left";
      }
      return text;
    });
  });
}

}  // namespace umbra
