#include "server/accounts/attempts.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

using namespace std::chrono_literals;

struct AttemptsTest : testing::Test {
  // An attempt that fails, if it may be made.
  bool fails(const std::string& address, const std::string& account) {
    return attempts.begin(address, account, now).has_value();
  }
  // One with the right password.
  bool succeeds(const std::string& address, const std::string& account) {
    const auto attempt = attempts.begin(address, account, now);
    if (attempt) attempts.succeed(*attempt, now);
    return attempt.has_value();
  }
  int failures(const std::string& address, const std::string& account, int most) {
    int made = 0;
    while (made < most && fails(address, account)) ++made;
    return made;
  }
  // Guesses from so many addresses, each as often as it may.
  int guesses(int addresses, const std::string& account) {
    int made = 0;
    for (int i = 0; i < addresses; ++i) made += failures("guesser" + std::to_string(i), account, 100);
    return made;
  }

  Attempts attempts;
  Attempts::Time now{};
};

TEST_F(AttemptsTest, OfAnAddressTenAtOnceThenOneInSixSeconds) {
  EXPECT_EQ(failures("1", "ada", 5), 5);
  EXPECT_EQ(failures("1", "eve", 100), 5);
  EXPECT_EQ(attempts.begin("1", "joe", now).error(), 6s) << "whoever it tries";
  EXPECT_TRUE(fails("2", "ada")) << "others are not kept out";
  now += 6s;
  EXPECT_EQ(failures("1", "joe", 100), 1);
  now += 1h;
  EXPECT_EQ(failures("1", "joe", 100), 10);
}

TEST_F(AttemptsTest, WhereNoAccountIsNamedTheAddressAloneCounts) {
  int made = 0;
  for (int i = 0; i < 200; ++i) made += failures(std::to_string(i), "", 100);
  EXPECT_EQ(made, 200 * 10);
  EXPECT_FALSE(fails("1", "ada")) << "of the same bucket";
  now += 1h;
  for (int i = 0; i < 100; ++i) attempts.drop(*attempts.begin("1", "", now), now);
  EXPECT_EQ(failures("1", "", 100), 10);
}

TEST_F(AttemptsTest, OfAnAccountFromOneAddressTenAtOnceThenOneInThirtySeconds) {
  EXPECT_EQ(failures("1", "ada", 100), 10);
  now += 29s;
  EXPECT_FALSE(fails("1", "ada"));
  EXPECT_TRUE(fails("1", "eve"));
  now += 1s;
  EXPECT_EQ(failures("1", "ada", 100), 1);
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

TEST_F(AttemptsTest, OneAddressNeverEmptiesTheBucketOfAnAccount) {
  for (int second = 0; second < 3600; ++second) {
    failures("guesser", "ada", 100);
    now += 1s;
    if (second % 60 == 0) {
      ASSERT_TRUE(succeeds("fresh" + std::to_string(second), "ada")) << second;
    }
  }
}

TEST_F(AttemptsTest, TheOwnerLogsInFromWhereTheyDidBeforeHoweverManyGuess) {
  ASSERT_TRUE(succeeds("home", "ada"));
  for (int minute = 0; minute < 60; ++minute) {
    guesses(20, "ada");
    ASSERT_FALSE(fails("fresh" + std::to_string(minute), "ada")) << "the account's bucket is empty";
    ASSERT_TRUE(succeeds("home", "ada")) << minute;
    now += 1min;
  }
  EXPECT_EQ(failures("home", "ada", 100), 10) << "who is known there may not guess more";
}

TEST_F(AttemptsTest, AnAddressIsKnownForAMonthSinceTheLastLogin) {
  ASSERT_TRUE(succeeds("home", "ada"));
  now += Attempts::kKnown - 1h;
  guesses(20, "ada");
  EXPECT_TRUE(succeeds("home", "ada"));
  now += Attempts::kKnown - 1h;
  guesses(20, "ada");
  EXPECT_TRUE(fails("home", "ada"));
  now += 2h;
  guesses(20, "ada");
  EXPECT_FALSE(succeeds("home", "ada"));
}

TEST_F(AttemptsTest, AnAccountIsKnownAtItsLastAddresses) {
  for (std::size_t i = 0; i <= Attempts::kMostKnown; ++i) ASSERT_TRUE(succeeds("home" + std::to_string(i), "ada"));
  ASSERT_TRUE(succeeds("home", "eve"));
  guesses(20, "ada");
  EXPECT_FALSE(fails("home0", "ada"));
  EXPECT_TRUE(fails("home1", "ada"));
  EXPECT_FALSE(fails("home", "ada")) << "known there is another";
  guesses(20, "eve");
  EXPECT_TRUE(fails("home", "eve"));
}

TEST_F(AttemptsTest, KeepsAFewThousandKnownAddresses) {
  for (std::size_t i = 0; i <= Attempts::kMostKnownOfAll; ++i) ASSERT_TRUE(succeeds("home", "a" + std::to_string(i)));
  guesses(20, "a0");
  EXPECT_FALSE(fails("home", "a0"));
  now += 1h;
  guesses(20, "a1");
  EXPECT_TRUE(fails("home", "a1"));
}

TEST_F(AttemptsTest, WhatIsRefusedForTheSakeOfTheAccountCostsTheAddress) {
  guesses(20, "ada");
  for (int i = 0; i < 10; ++i) EXPECT_EQ(attempts.begin("other", "ada", now).error(), 20s);
  EXPECT_FALSE(fails("other", "eve"));
  now += 6s;
  EXPECT_TRUE(fails("other", "eve")) << "what is refused for the sake of the address costs nothing";
}

TEST_F(AttemptsTest, OneThatSucceedsOrIsNotMadeCountsNothing) {
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(succeeds("1", "ada")) << i;
  for (int i = 0; i < 100; ++i) {
    const auto attempt = attempts.begin("2", "ada", now);
    ASSERT_TRUE(attempt) << i;
    attempts.drop(*attempt, now);
  }
  EXPECT_EQ(failures("1", "ada", 100), 10);
  EXPECT_EQ(failures("2", "ada", 100), 10);
}

// What it has taken of the account's bucket is given back there, though its address has become known meanwhile.
TEST_F(AttemptsTest, TwoThatSucceedAtOnceCountNothing) {
  for (int i = 0; i < 100; ++i) {
    const std::string address = "home" + std::to_string(i);
    const auto first = attempts.begin(address, "ada", now), second = attempts.begin(address, "ada", now);
    ASSERT_TRUE(first && second);
    attempts.succeed(*first, now);
    attempts.succeed(*second, now);
  }
  EXPECT_EQ(guesses(20, "ada"), 50);
}

TEST_F(AttemptsTest, AttemptsThatAreUnderWayCount) {
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(attempts.begin("1", "ada", now));
  EXPECT_FALSE(attempts.begin("1", "ada", now));
}

TEST_F(AttemptsTest, KeepsTheEmptiestBucketsOfMany) {
  EXPECT_EQ(failures("guesser", "ada", 100), 10);
  for (std::size_t i = 0; i < 2 * Attempts::kMost; ++i) fails("many" + std::to_string(i), "x" + std::to_string(i));
  EXPECT_FALSE(fails("guesser", "eve"));
}

}  // namespace
}  // namespace race::server
