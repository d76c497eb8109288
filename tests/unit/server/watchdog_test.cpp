#include "server/threads/watchdog.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

using std::chrono::milliseconds;

TEST(Watchdog, SetsAFlagWhenTheTimeIsOver) {
  Watchdog watchdog;
  const auto flag = std::make_shared<std::atomic<bool>>(false);
  const auto watch = watchdog.watch(flag, milliseconds(1));
  for (int i = 0; i < 500 && !*flag; ++i) std::this_thread::sleep_for(milliseconds(10));
  EXPECT_TRUE(*flag);
}

TEST(Watchdog, SetsNoFlagOfWorkThatIsOver) {
  Watchdog watchdog;
  const auto flag = std::make_shared<std::atomic<bool>>(false), later = std::make_shared<std::atomic<bool>>(false);
  { const auto watch = watchdog.watch(flag, milliseconds(1)); }
  const auto slow = watchdog.watch(later, std::chrono::hours(1));
  std::this_thread::sleep_for(3 * Watchdog::kPeriod);
  EXPECT_FALSE(*flag);
  EXPECT_FALSE(*later);
}

}  // namespace
}  // namespace race::server
