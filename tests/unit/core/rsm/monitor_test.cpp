// The monitor on the robot service of Fig. 4.1: no violation while the service does what it declares, and each kind of
// violation.
#include "core/rsm/monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/rsm/robot.h"

namespace race::rsm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

MATCHER_P2(Breaks, rule, call, "breaks " + std::string(rule)) {
  return arg.rule == rule && arg.call == static_cast<Monitor::CallId>(call) && !arg.message.empty();
}

class RobotMonitor : public testing::Test {
 protected:
  Monitor monitor{read_robot()};
  const Value pose = Dict{{"position", List{0, 0, 0}}, {"orientation", List{0, 0, 0, 1}}};
  const Value moved = Dict{{"duration", 1.5}};

  void move(Monitor::CallId call) {
    ASSERT_THAT(monitor.called(call, "move", {pose}, {}), IsEmpty());
    const bool idle = monitor.current() == "Idle";
    ASSERT_THAT(monitor.transition(idle ? "start" : "again", call), IsEmpty());
    if (idle) {
      ASSERT_THAT(monitor.event("started", Value()), IsEmpty());
    }
  }
};

TEST_F(RobotMonitor, IsSilentForAMotion) {
  EXPECT_THAT(monitor.event("robot_state", 1), IsEmpty());
  move(1);
  EXPECT_EQ(monitor.current(), "Moving");
  EXPECT_THAT(monitor.open_calls(), ElementsAre(1));
  EXPECT_THAT(monitor.transition("arrive", 0), IsEmpty());
  EXPECT_THAT(monitor.result(1, moved), IsEmpty());
  EXPECT_THAT(monitor.open_calls(), IsEmpty());
}

TEST_F(RobotMonitor, IsSilentForAStop) {
  move(1);
  EXPECT_THAT(monitor.called(2, "stop", {}, {}), IsEmpty());
  EXPECT_THAT(monitor.transition("stop", 2), IsEmpty());
  EXPECT_THAT(monitor.error(1, Dict{{"code", "aborted"}}), IsEmpty());
  EXPECT_THAT(monitor.result(2, Value()), IsEmpty());
}

TEST_F(RobotMonitor, IsSilentForADeclaredError) {
  move(1);
  monitor.transition("arrive", 0);
  EXPECT_THAT(monitor.error(1, Dict{{"code", "collision"}}), IsEmpty());
}

TEST_F(RobotMonitor, IsSilentForARejectionThatTheStateAsksFor) {
  move(1);
  EXPECT_THAT(monitor.called(2, "change_behavior", {"soft"}, {}), IsEmpty());
  EXPECT_THAT(monitor.rejected(2), IsEmpty());
}

TEST_F(RobotMonitor, ReportsATransitionFromAnotherState) {
  EXPECT_THAT(monitor.transition("arrive", 0), ElementsAre(Breaks("Trans2", 0)));
  move(1);
  monitor.called(2, "change_behavior", {"soft"}, {});
  EXPECT_THAT(monitor.transition("change", 2), ElementsAre(Breaks("Trans1", 2)));
  EXPECT_EQ(monitor.current(), "Idle") << "it follows what was announced";
}

TEST_F(RobotMonitor, ReportsATransitionOnAWrongCall) {
  EXPECT_THAT(monitor.transition("start", 0), ElementsAre(Breaks("Trans1", 0)));
  Monitor other{read_robot()};
  other.called(1, "stop", {}, {});
  EXPECT_THAT(other.transition("start", 1), ElementsAre(Breaks("Trans1", 1)));
  Monitor third{read_robot()};
  third.called(1, "move", {pose}, {});
  third.transition("start", 1);
  third.event("started", Value());
  EXPECT_THAT(third.transition("arrive", 1), ElementsAre(Breaks("Trans2", 1)));
}

TEST_F(RobotMonitor, ReportsACallThatDoesNotTakeTheFirstTransition) {
  Service two = read_robot();
  two.transitions.push_back({"late", "Idle", "Moving", "change_behavior", {}, {}, {}});
  Monitor monitor_of_two{two};
  monitor_of_two.called(1, "change_behavior", {"soft"}, {});
  EXPECT_THAT(monitor_of_two.transition("late", 1), ElementsAre(Breaks("Trans1", 1)));
}

TEST_F(RobotMonitor, ReportsAnUndeclaredTransitionAndEvent) {
  EXPECT_THAT(monitor.transition("fly", 0), ElementsAre(Breaks("declared", 0)));
  EXPECT_THAT(monitor.event("landed", Value()), ElementsAre(Breaks("declared", 0)));
}

TEST_F(RobotMonitor, ReportsARejectionOfWhatTheStateTakes) {
  monitor.called(1, "move", {pose}, {});
  EXPECT_THAT(monitor.rejected(1), ElementsAre(Breaks("R7", 1)));
  EXPECT_THAT(monitor.rejected(1), ElementsAre(Breaks("R7", 1))) << "no such call any more";
}

TEST_F(RobotMonitor, ReportsAResponseBeforeItIsDue) {
  monitor.called(1, "move", {pose}, {});
  EXPECT_THAT(monitor.result(1, moved), ElementsAre(Breaks("respond", 1)));
  move(2);
  EXPECT_THAT(monitor.result(2, moved), ElementsAre(Breaks("respond", 2)));
}

TEST_F(RobotMonitor, ReportsAResponseWithoutAnOpenCall) {
  EXPECT_THAT(monitor.result(9, moved), ElementsAre(Breaks("respond", 9)));
  move(1);
  monitor.transition("arrive", 0);
  EXPECT_THAT(monitor.result(1, moved), IsEmpty());
  EXPECT_THAT(monitor.result(1, moved), ElementsAre(Breaks("respond", 1)));
}

TEST_F(RobotMonitor, ReportsAResponseToACallThatALaterOneSuperseded) {  // R17
  move(1);
  move(2);
  EXPECT_EQ(monitor.superseded(), 0U);
  move(3);
  EXPECT_EQ(monitor.superseded(), 2U);
  EXPECT_THAT(monitor.open_calls(), ElementsAre(1, 3));
  monitor.transition("arrive", 0);
  EXPECT_EQ(monitor.superseded(), 0U) << "of the last transition";
  EXPECT_THAT(monitor.result(2, moved), ElementsAre(Breaks("respond", 2)));
  EXPECT_THAT(monitor.result(3, moved), IsEmpty());
}

TEST_F(RobotMonitor, ReportsAnotherAnswerThanTheErrorOfTheTransition) {
  move(1);
  monitor.called(2, "stop", {}, {});
  monitor.transition("stop", 2);
  EXPECT_THAT(monitor.result(1, moved), ElementsAre(Breaks("respond", 1)));
  move(3);
  monitor.called(4, "stop", {}, {});
  monitor.transition("stop", 4);
  EXPECT_THAT(monitor.error(3, Dict{{"code", "collision"}}), ElementsAre(Breaks("respond", 3)));
}

TEST_F(RobotMonitor, ReportsAnErrorOfAnOperationThatDeclaresNone) {
  monitor.called(1, "stop", {}, {});
  monitor.transition("stop", 1);
  EXPECT_THAT(monitor.error(1, Dict{{"code", "no"}}), ElementsAre(Breaks("declared", 1)));
}

TEST_F(RobotMonitor, ReportsValuesOfAnotherType) {
  EXPECT_THAT(monitor.event("robot_state", "x"), ElementsAre(Breaks("type", 0)));
  move(1);
  monitor.transition("arrive", 0);
  EXPECT_THAT(monitor.result(1, Dict{{"duration", "long"}}), ElementsAre(Breaks("type", 1)));
  move(2);
  monitor.transition("arrive", 0);
  EXPECT_THAT(monitor.error(2, "broken"), ElementsAre(Breaks("type", 2), Breaks("type", 2)));
}

TEST_F(RobotMonitor, ReportsArgumentsThatTheOperationDoesNotTake) {
  EXPECT_THAT(monitor.called(1, "move", {}, {}), ElementsAre(Breaks("type", 1)));
  EXPECT_THAT(monitor.called(2, "move", {pose, "fast"}, {}), ElementsAre(Breaks("type", 2)));
  EXPECT_THAT(monitor.called(3, "move", {pose, 1, 2}, {}), ElementsAre(Breaks("type", 3)));
  EXPECT_THAT(monitor.called(4, "move", {}, {{"pose", pose}, {"where", 1}}), ElementsAre(Breaks("type", 4)));
  EXPECT_THAT(monitor.called(5, "move", {}, {{"pose", pose}, {"speed", 2}}), IsEmpty());
  EXPECT_THAT(monitor.called(6, "fly", {}, {}), ElementsAre(Breaks("declared", 6)));
}

TEST_F(RobotMonitor, ReportsAnEventThatTheStateDoesNotEmit) {
  EXPECT_THAT(monitor.event("started", Value()), ElementsAre(Breaks("Stutter", 0)));
  move(1);
  EXPECT_THAT(monitor.event("robot_state", 1), ElementsAre(Breaks("Stutter", 0)));
}

TEST_F(RobotMonitor, ReportsAnEventThatATransitionShouldHavePut) {
  monitor.called(1, "move", {pose}, {});
  monitor.transition("start", 1);
  EXPECT_THAT(monitor.transition("arrive", 0), ElementsAre(Breaks("put", 0)));
}

TEST_F(RobotMonitor, RestartsWithTheService) {
  move(1);
  monitor.restarted();
  EXPECT_EQ(monitor.current(), "Idle");
  EXPECT_THAT(monitor.open_calls(), IsEmpty());
  EXPECT_THAT(monitor.event("robot_state", 1), IsEmpty());
}

// Two calls of `wait`, of which each answer names its own (R25).
struct TimerMonitor : testing::Test {
  TimerMonitor() {
    for (const Monitor::CallId call : {1, 2}) {
      monitor.called(call, "wait", {}, {});
      monitor.transition("begin", call);
    }
  }
  Monitor monitor{read_service_text(R"({
    "rsm": 1, "name": "timer", "operations": [{"name": "wait", "error": "any"}], "states": [{"name": "On"}], "init": "On",
    "transitions": [
      {"id": "begin", "src": "On", "dst": "On", "operation": "wait", "defer": ["over"], "concurrent": true},
      {"id": "over", "src": "On", "dst": "On"}]})",
                                    "services/timer")
                      .value()};
};

TEST_F(TimerMonitor, IsSilentForAnswersInAnyOrder) {
  for (const Monitor::CallId call : {2, 1}) {
    EXPECT_THAT(monitor.transition("over", call), IsEmpty());
    EXPECT_THAT(monitor.result(call, Value()), IsEmpty());
  }
}

TEST_F(TimerMonitor, ExpectsNoAnswerToACallThatWasAnsweredTooEarly) {
  EXPECT_THAT(monitor.result(1, Value()), ElementsAre(Breaks("respond", 1)));
  EXPECT_THAT(monitor.transition("over", 0), IsEmpty());
  EXPECT_THAT(monitor.result(2, Value()), IsEmpty()) << "the earliest that waits is the second";
}

TEST_F(TimerMonitor, ExpectsNoAnswerToACallThatWasRejectedTooLate) {
  EXPECT_THAT(monitor.rejected(1), ElementsAre(Breaks("R7", 1)));
  EXPECT_THAT(monitor.transition("over", 1), ElementsAre(Breaks("Trans2", 1)));
  EXPECT_THAT(monitor.open_calls(), ElementsAre(2));
}

TEST(InterfaceMonitor, ChecksNamesTypesAndThatACallIsAnsweredOnce) {
  Monitor monitor{
      read_service_text(R"({"operations": [{"name": "op", "result": "int"}], "events": [{"name": "e"}]})", "services/S")
          .value()};
  EXPECT_THAT(monitor.event("e", Value()), IsEmpty());
  EXPECT_THAT(monitor.called(1, "op", {}, {}), IsEmpty());
  EXPECT_THAT(monitor.result(1, 3), IsEmpty());
  EXPECT_THAT(monitor.result(1, 3), ElementsAre(Breaks("respond", 1)));
  monitor.called(2, "op", {}, {});
  EXPECT_THAT(monitor.result(2, "x"), ElementsAre(Breaks("type", 2)));
}

}  // namespace
}  // namespace race::rsm
