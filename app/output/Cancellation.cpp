#include "app/output/Cancellation.h"

#include <signal.h>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

// A signal handler reaches nothing but a variable with static storage.
volatile sig_atomic_t stopAsked = 0;

}  // namespace

void catchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = [](int) { stopAsked = 1; };
  sigemptyset(&action.sa_mask);
  // The handler is used up by the first signal: a second one ends a step that takes too long.
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void throwIfCancelled() {
  if (stopAsked) throw Error(ErrorKind::Cancelled, "cancelled");
}

}  // namespace umbra
