// Work on every core.
#pragma once

#include <functional>

namespace umbra {

// Calls `work` for 0 … count − 1 on every core, in any order; the first exception ends it and is
// thrown. `between` is called by the calling thread alone, before each of its own shares, with how
// many have been begun: it tells how far the work is, and what it throws stops it.
void onEveryCore(int count, const std::function<void(int)>& work,
                 const std::function<void(int)>& between);

}  // namespace umbra
