// Work on every core.
#pragma once

#include <functional>

namespace umbra {

// Calls `work` for 0 … count − 1 on every core, in any order; the first exception ends it. Can be
// interrupted: only the calling thread looks for that.
void onEveryCore(int count, const std::function<void(int)>& work);

}  // namespace umbra
