// Work on every core.
#pragma once

#include <functional>

namespace umbra {

// Calls `work` for 0 … count − 1 on every core, in any order; the first exception ends it and is
// thrown. `between` is called by the calling thread alone, with how many have been begun: with 0
// before any is, unless there is none, and then before each of its own shares. It tells how far the
// work is, and what it throws stops it: the first time before anything is done, so that even the
// least work can be stopped.
void onEveryCore(int count, const std::function<void(int)>& work,
                 const std::function<void(int)>& between);

}  // namespace umbra
