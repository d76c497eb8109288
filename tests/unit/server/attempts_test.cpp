#include "server/accounts/attempts.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

using namespace std::chrono_literals;

struct AttemptsTest : testing::Test {
  // An attempt that fails, if it may be made.
  bool fails(const std::string& address, const std::string& account) {
    if (attempts.wait(address, account, now)) return false;
    attempts.begun(address, account, now);
    return true;
  }
  int failures(const std::string& address, const std::string& account, int most) {
    int made = 0;
    while (made < most && fails(address, account)) ++made;
    return made;
  }

  Attempts attempts;
  Attempts::Time now{};
};

TEST_F(AttemptsTest, OfAnAddressTenAtOnceThenOneInSixSeconds) {
  EXPECT_EQ(failures("1", "ada", 100), 10);
  EXPECT_EQ(attempts.wait("1", "ada", now), 6s);
  EXPECT_EQ(attempts.wait("1", "eve", now), 6s) << "whoever it tries";
  EXPECT_FALSE(attempts.wait("2", "ada", now)) << "others are not kept out";
  now += 6s;
  EXPECT_EQ(failures("1", "ada", 100), 1);
  now += 1h;
  EXPECT_EQ(failures("1", "ada", 100), 10);
}

TEST_F(AttemptsTest, OfAnAccountFiftyFromManyAddressesThenOneInTwentySeconds) {
  int made = 0;
  for (int i = 0; i < 200; ++i) made += fails(std::to_string(i), "ada") ? 1 : 0;
  EXPECT_EQ(made, 50);
  EXPECT_FALSE(fails("other", "ada"));
  EXPECT_TRUE(fails("other", "eve"));
  now += 20s;
  EXPECT_TRUE(fails("other", "ada"));
  EXPECT_FALSE(fails("another", "ada"));
}

TEST_F(AttemptsTest, OneThatSucceedsCountsNothing) {
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(fails("1", "ada")) << i;
    attempts.not_failed("1", "ada", now);
  }
  EXPECT_EQ(failures("1", "ada", 100), 10);
}

TEST_F(AttemptsTest, AttemptsThatAreUnderWayCount) {
  for (int i = 0; i < 10; ++i) attempts.begun("1", "ada", now);
  EXPECT_TRUE(attempts.wait("1", "ada", now));
}

TEST_F(AttemptsTest, KeepsTheEmptiestBucketsOfMany) {
  EXPECT_EQ(failures("guesser", "ada", 100), 10);
  for (std::size_t i = 0; i < 2 * Attempts::kMost; ++i) fails("many" + std::to_string(i), "x" + std::to_string(i));
  EXPECT_TRUE(attempts.wait("guesser", "eve", now));
}

}  // namespace
}  // namespace race::server
