#include "services/time_slice.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <thread>

namespace race::services {
namespace {

TEST(TimeSlice, IsShortOfTheThreadThatAsksWhereTheKernelHasOne) {
  const auto usual = time_slice();
  std::optional<std::chrono::nanoseconds> shortened;
  int nice = 0;
  std::thread([&] {
    setpriority(PRIO_PROCESS, 0, 3);
    shorten_time_slice();
    shortened = time_slice();
    nice = getpriority(PRIO_PROCESS, 0);
  }).join();
  EXPECT_EQ(nice, 3);  // its share of the processors stays what it is
  EXPECT_EQ(time_slice(), usual);
  if (usual) {
    EXPECT_EQ(shortened, kShortSlice);
  }
}

}  // namespace
}  // namespace race::services
