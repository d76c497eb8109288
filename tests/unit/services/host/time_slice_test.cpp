#include "services/time_slice.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/utsname.h>

#include <cstdio>
#include <thread>
#include <utility>

namespace race::services {
namespace {

/// From Linux 6.12 on.
bool has_time_slices() {
  utsname system{};
  std::pair<int, int> version;
  uname(&system);
  return std::sscanf(system.release, "%d.%d", &version.first, &version.second) == 2 && version >= std::pair(6, 12);
}

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
  EXPECT_EQ(usual.has_value(), has_time_slices());
  EXPECT_EQ(nice, 3);  // its share of the processors stays what it is
  EXPECT_EQ(time_slice(), usual);
  if (usual) {
    EXPECT_EQ(shortened, kShortSlice);
  }
}

}  // namespace
}  // namespace race::services
