#include "app/EveryCore.h"

#include "analysis/EveryCore.h"
#include "app/Cancellation.h"

namespace umbra {

void onEveryCore(int count, const std::function<void(int)>& work) {
  onEveryCore(count, work, [](int) { throwIfCancelled(); });
}

}  // namespace umbra
