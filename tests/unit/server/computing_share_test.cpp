// A share of computing: who keeps within it, a burst, and who does not.
#include "server/threads/computing_share.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

using namespace std::chrono_literals;

struct ComputingShareTest : testing::Test {
  /// Computes so long of each period, so often; whether it was over its share at the end.
  bool compute(std::chrono::microseconds computed, std::chrono::microseconds period, int times) {
    for (int i = 0; i < times; ++i) {
      now += period;
      share.add(computed, now);
    }
    return share.is_over(now);
  }
  ComputingShare share;
  std::chrono::steady_clock::time_point now{1h};
};

TEST_F(ComputingShareTest, IsKeptByWhoComputesLittle) { EXPECT_FALSE(compute(300us, 20ms, 1000)); }

TEST_F(ComputingShareTest, AllowsABurst) {
  EXPECT_FALSE(compute(2ms, 100ms, 1));
  EXPECT_TRUE(compute(1ms, 1ms, 1)) << "but no other at once";
}

TEST_F(ComputingShareTest, IsExceededByManySmallPieces) { EXPECT_TRUE(compute(100us, 200us, 1000)); }

TEST_F(ComputingShareTest, IsOverForASecondAtMost) {
  EXPECT_TRUE(compute(10s, 10s, 1));
  now += 999ms;
  EXPECT_TRUE(share.is_over(now));
  now += 1ms;
  EXPECT_FALSE(share.is_over(now));
}

}  // namespace
}  // namespace race::server
