// Calls of a person who holds a button: what is one motion, and what comes of a button that was not let go of.
#include "server/control/held_operation.h"

#include <gtest/gtest.h>

#include <string>

namespace race::server {
namespace {

using namespace std::chrono_literals;

struct HeldOperationTest : testing::Test {
  /// Whether the button is held over; a call each 50 ms.
  bool held_over(std::uint64_t fence, const char* service = "robot") {
    now += 50ms;
    return held.is_held_over(service, fence, now);
  }
  HeldOperation held;
  HeldOperation::Steady now = HeldOperation::Steady() + 1h;
};

TEST_F(HeldOperationTest, IsHeldOverTheEndOfItsPermissionUntilItIsLetGoOf) {
  EXPECT_FALSE(held_over(1));
  EXPECT_FALSE(held_over(1));
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(held_over(2)) << "somebody has reset the stop";
  now += Control::kSilence;
  EXPECT_FALSE(held_over(2)) << "pressed again";
}

TEST_F(HeldOperationTest, IsHeldOverWhicheverOperationItCalls) {
  EXPECT_FALSE(held_over(1));
  held.begins("robot", "jog", now);
  EXPECT_TRUE(held_over(2));
  held.begins("robot", "guide", now);
  EXPECT_TRUE(held_over(2));
}

TEST_F(HeldOperationTest, ThatSomebodyHasStoppedIsHeldOverUntilItIsLetGoOf) {
  held.end("robot");
  EXPECT_FALSE(held_over(2)) << "nothing was held";
  EXPECT_TRUE(held.begins("robot", "jog", now));
  held.end("crane");
  EXPECT_FALSE(held_over(2)) << "another service";
  held.end("robot");
  EXPECT_FALSE(held.goes_on("robot", now));
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(held_over(2)) << "its permission goes on";
  now += Control::kSilence;
  EXPECT_FALSE(held_over(2)) << "pressed again";
  EXPECT_TRUE(held.begins("robot", "jog", now)) << "another motion";
}

TEST_F(HeldOperationTest, OfAnotherServiceIsAnotherButton) {
  EXPECT_FALSE(held_over(1));
  EXPECT_FALSE(held_over(2, "crane"));
}

TEST_F(HeldOperationTest, TwoButtonsThatAreHeldAtOnceAreBothHeldOver) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(held_over(1));
    EXPECT_FALSE(held_over(1, "crane"));
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(held_over(2));
    EXPECT_TRUE(held_over(2, "crane"));
  }
}

TEST_F(HeldOperationTest, TheServiceThatWasCalledTheLongestAgoIsForgotten) {
  const auto soon = [&](const std::string& service, std::uint64_t fence) {
    return held.is_held_over(service, fence, now += 1ms);
  };
  EXPECT_FALSE(soon("first", 1));
  for (std::size_t i = 1; i < HeldOperation::kMostServices; ++i) soon("s" + std::to_string(i), 1);
  EXPECT_TRUE(soon("s1", 2)) << "so many are known";
  soon("one more", 1);
  EXPECT_FALSE(soon("first", 2)) << "as if it were pressed anew";
}

TEST_F(HeldOperationTest, BeginsOnceForEachMotion) {
  EXPECT_TRUE(held.begins("robot", "jog", now));
  EXPECT_FALSE(held.begins("robot", "jog", now + 1s));
  EXPECT_FALSE(held.begins("robot", "jog", now + 2s)) << "since the last call, not the first";
  EXPECT_TRUE(held.begins("robot", "guide", now + 2s)) << "another operation";
  EXPECT_TRUE(held.begins("crane", "guide", now + 2s)) << "another service";
  EXPECT_TRUE(held.begins("crane", "guide", now + 3001ms));
}

TEST_F(HeldOperationTest, GoesOnForATimeAfterTheLastCall) {
  EXPECT_FALSE(held.goes_on("robot", now)) << "there was none";
  held.begins("robot", "jog", now);
  EXPECT_TRUE(held.goes_on("robot", now + 1s));
  EXPECT_FALSE(held.goes_on("robot", now + 1001ms));
  EXPECT_FALSE(held.goes_on("crane", now));
}

TEST_F(HeldOperationTest, ACallThatIsHeldOverIsNoMotion) {
  held_over(1);
  held.begins("robot", "jog", now);
  for (int i = 0; i < 30; ++i) held_over(2);
  EXPECT_FALSE(held.goes_on("robot", now));
}

}  // namespace
}  // namespace race::server
