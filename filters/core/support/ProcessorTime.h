// The processor time of this process.
#pragma once

#include <ctime>

namespace umbra {

// The milliseconds that all threads of the process together have computed since it began. Other
// programs on a busy machine hardly disturb differences of it.
inline double processorMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

}  // namespace umbra
