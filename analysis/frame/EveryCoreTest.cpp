#include "analysis/frame/EveryCore.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace umbra {
namespace {

TEST(EveryCore, DoesEveryShareOnce) {
  std::vector<std::atomic<int>> done(1000);
  int before = -1;
  const auto caller = std::this_thread::get_id();
  onEveryCore(
      1000, [&](int i) { ++done[i]; },
      [&](int begun) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_GT(begun, before);
        before = begun;
      });
  for (const auto& times : done) EXPECT_EQ(times, 1);
  onEveryCore(
      0, [](int) { FAIL(); }, [](int) { FAIL(); });
}

TEST(EveryCore, TheFirstExceptionEndsTheWork) {
  std::atomic<int> done = 0;
  const auto failing = [&](int i) {
    if (i == 3) throw std::runtime_error("three");
    ++done;
  };
  EXPECT_THROW(onEveryCore(1 << 30, failing, [](int) {}), std::runtime_error);
  EXPECT_LT(done, 1 << 30);
  EXPECT_THROW(onEveryCore(
                   1 << 30, [](int) {}, [](int) { throw std::runtime_error("stopped"); }),
               std::runtime_error);
}

// If `between` were called only before the calling thread's own calls, other threads could have
// done all the work by then.
TEST(EveryCore, EvenTheLeastWorkCanBeStopped) {
  int done = 0;
  for (int times = 0; times < 300; ++times)
    EXPECT_THROW(onEveryCore(
                     1, [&](int) { ++done; }, [](int) { throw std::runtime_error("stopped"); }),
                 std::runtime_error);
  EXPECT_EQ(done, 0);
}

}  // namespace
}  // namespace umbra
