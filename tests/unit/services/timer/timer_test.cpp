#include "services/timer/timer.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/unit/services/host/bench.h"

namespace race::timer {
namespace {

using services::Bench;
using services::Delivery;
using testing::ElementsAre;
using testing::IsEmpty;

struct TimerTest : testing::Test {
  TimerTest() { bench.add<Timer>("timer"); }
  ~TimerTest() override { EXPECT_THAT(bench.violations("timer"), IsEmpty()); }
  int events(const std::string& name) const {
    int count = 0;
    for (const Delivery& each : bench.deliveries) count += each.kind == Delivery::Kind::event && each.name == name;
    return count;
  }
  Bench bench;
};

TEST_F(TimerTest, AnswersWhenTheTimeIsOverAndNotBefore) {
  bench.call("timer", "start", {0.25});
  EXPECT_EQ(bench.host.service("timer")->state, "Running");
  bench.pass(0.249);
  EXPECT_THAT(bench.responses(), IsEmpty());
  bench.pass(0.001);
  EXPECT_THAT(bench.responses(), ElementsAre("timer.start -> {\"elapsed\":0.25}"));
  EXPECT_EQ(events("elapsed"), 1);
  EXPECT_EQ(bench.host.service("timer")->state, "Idle");
}

TEST_F(TimerTest, CanBeStartedAgain) {
  for (int i = 0; i < 2; ++i) {
    bench.call("timer", "start", {1});
    bench.pass(1.0);
  }
  EXPECT_EQ(bench.responses().size(), 2U);
  EXPECT_EQ(events("elapsed"), 2);
}

TEST_F(TimerTest, ACancelledStartIsAnsweredWithAnError) {
  bench.call("timer", "start", {1});
  bench.call("timer", "cancel");
  bench.pass(2.0);
  EXPECT_THAT(bench.responses(), ElementsAre("timer.start !> cancelled", "timer.cancel -> null"));
  EXPECT_EQ(events("elapsed"), 0);
}

TEST_F(TimerTest, RejectsWhatItsStateDoesNotAccept) {
  bench.call("timer", "cancel");
  bench.call("timer", "start", {1});
  bench.call("timer", "start", {1});
  EXPECT_THAT(bench.responses(), ElementsAre("timer.cancel !> not_accepted", "timer.start !> not_accepted"));
}

TEST_F(TimerTest, AnswersEachOfManyWaitsByItself) {
  bench.call("timer", "wait", {0.3});
  bench.call("timer", "start", {0.15});
  bench.call("timer", "wait", {0.1});
  bench.call("timer", "wait", {0.2});
  EXPECT_EQ(bench.host.service("timer")->state, "Running");
  bench.pass(0.1);
  EXPECT_THAT(bench.responses(), ElementsAre("timer.wait -> {\"elapsed\":0.1}"));
  bench.pass(0.2);
  EXPECT_EQ(bench.responses().size(), 4U);
  EXPECT_EQ(events("elapsed"), 1) << "of the alarm alone";
  EXPECT_EQ(bench.host.service("timer")->state, "Idle");
}

TEST_F(TimerTest, LeavesWaitsAloneWhenTheAlarmIsCancelled) {
  bench.call("timer", "start", {1});
  bench.call("timer", "wait", {0.1});
  bench.call("timer", "cancel");
  bench.pass(0.1);
  EXPECT_THAT(bench.responses(),
              ElementsAre("timer.start !> cancelled", "timer.cancel -> null", "timer.wait -> {\"elapsed\":0.1}"));
}

TEST_F(TimerTest, AnswersWaitsThatEndTogetherInTheirOrder) {
  for (int i = 0; i < 3; ++i) bench.call("timer", "wait", {0.1});
  bench.pass(0.1);
  std::vector<std::uint64_t> calls;
  for (const Delivery& each : bench.deliveries)
    if (each.kind == Delivery::Kind::response) calls.push_back(each.caller.call);
  EXPECT_THAT(calls, ElementsAre(1, 2, 3));
}

TEST_F(TimerTest, BoundsItsWaits) {
  for (std::size_t i = 0; i < Timer::kMostWaits; ++i) bench.call("timer", "wait", {10});
  EXPECT_THAT(bench.responses(), IsEmpty());
  bench.call("timer", "wait", {0});
  EXPECT_THAT(bench.responses(), ElementsAre("timer.wait !> too_many"));
  bench.pass(10.0);
  EXPECT_EQ(bench.responses().size(), Timer::kMostWaits + 1);
}

TEST_F(TimerTest, AnAbandonedWaitIsAnsweredAtOnceAndLeavesItsPlace) {
  for (std::size_t i = 0; i < Timer::kMostWaits; ++i) bench.call("timer", "wait", {10});
  bench.host.abandon({"1", 500});
  bench.queue.run();
  ASSERT_THAT(bench.responses(), ElementsAre("timer.wait !> abandoned"));
  EXPECT_EQ(bench.deliveries.back().caller.call, 500U);
  bench.call("timer", "wait", {0});
  EXPECT_EQ(bench.responses().size(), 1U) << "there is a place";
  bench.host.abandon_all("1");
  bench.queue.run();
  EXPECT_EQ(bench.responses().size(), Timer::kMostWaits + 1);
  for (std::size_t i = 0; i < Timer::kMostWaits; ++i) bench.call("timer", "wait", {1});
  bench.pass(1.0);
  EXPECT_EQ(bench.responses().size(), 2 * Timer::kMostWaits + 1);
  EXPECT_EQ(bench.responses().back(), "timer.wait -> {\"elapsed\":1.0}");
}

TEST_F(TimerTest, LeavesTheAlarmAloneWhenItsCallIsAbandoned) {
  bench.call("timer", "start", {0.1});
  bench.call("timer", "wait", {5});
  bench.host.abandon_all("1");
  bench.queue.run();
  EXPECT_THAT(bench.responses(), ElementsAre("timer.wait !> abandoned"));
  bench.pass(0.1);
  EXPECT_EQ(events("elapsed"), 1);
  EXPECT_EQ(bench.responses().back(), "timer.start -> {\"elapsed\":0.1}");
}

TEST_F(TimerTest, TicksTenTimesASecond) {
  bench.pass(1.05);
  EXPECT_EQ(events("tick"), 11);
}

// What a caller does wrong is recorded, but is no fault of the timer.
TEST(TimerArguments, AreAnsweredInvalidAtOnce) {
  Bench bench;
  bench.add<Timer>("timer");
  bench.call("timer", "start", {-1});
  bench.call("timer", "start", {"soon"});
  bench.call("timer", "start");
  bench.call("timer", "wait", {-1});
  EXPECT_THAT(bench.responses(), ElementsAre("timer.start !> invalid", "timer.start !> invalid",
                                             "timer.start !> invalid", "timer.wait !> invalid"));
  EXPECT_EQ(bench.host.service("timer")->state, "Idle");
  for (const auto& violation : bench.violations("timer")) EXPECT_EQ(violation.rule, "type");
}

TEST(TimerArguments, ThatAreNoFiniteNumberAreInvalidAndNothingRuns) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    Bench bench;
    bench.add<Timer>("timer");
    bench.call("timer", "start", {wrong});
    EXPECT_THAT(bench.responses(), ElementsAre("timer.start !> invalid")) << wrong;
    EXPECT_EQ(bench.host.service("timer")->state, "Idle");
    bench.pass(0.5);
    for (const Delivery& each : bench.deliveries) EXPECT_NE(each.name, "elapsed") << wrong;
  }
}

}  // namespace
}  // namespace race::timer
