// Work on every core.
#pragma once

#include <functional>

namespace umbra {

// Calls `work` for 0 … count − 1 on every core, in any order; the first exception ends the work and
// is thrown. Only the calling thread calls `between`, with the number of calls that have begun:
// with 0 before the first one (unless count is 0), and then before each call of its own. `between`
// may show progress. An exception that it throws stops the work; since it is first called before
// any work is done, even the shortest work can be stopped.
void onEveryCore(int count, const std::function<void(int)>& work,
                 const std::function<void(int)>& between);

}  // namespace umbra
