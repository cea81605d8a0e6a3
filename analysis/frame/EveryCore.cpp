#include "analysis/frame/EveryCore.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace umbra {

void onEveryCore(int count, const std::function<void(int)>& work,
                 const std::function<void(int)>& between) {
  if (count <= 0) return;
  between(0);
  std::atomic<int> next = 0;
  std::exception_ptr problem;
  std::mutex mutex;
  const auto run = [&](bool calling) {
    try {
      for (int i = next++; i < count; i = next++) {
        if (calling && i > 0) between(i);
        work(i);
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!problem) problem = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
      threads.emplace_back(run, false);
    run(true);
  }
  if (problem) std::rethrow_exception(problem);
}

}  // namespace umbra
