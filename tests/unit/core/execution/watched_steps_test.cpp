// Breakpoints on what a micro step does, after it and before it.
#include <gtest/gtest.h>

#include "core/execution/execution.h"
#include "core/execution/goal.h"
#include "core/execution/step_json.h"
#include "core/rcm/document.h"
#include "core/rcm/translate.h"

namespace race::execution {
namespace {

// Work counts the events `tick`, tells the lamp, and is left when the count is 3; Bad divides by what it was told.
constexpr const char* kWatchedModel = R"json({"rcm": 1, "root": {"state": "R", "first": "Work",
  "children": [
    {"state": "Work", "results": [{"name": "count", "initial": 0}], "first": "In", "children": [{"state": "In"}],
     "actions": [{"when": "svc.t.tick", "do": "res.count = res.count + 1", "meta": {"id": "count"}},
                 {"when": "svc.t.tick and res.count >= 2", "do": "svc.lamp.set(res.count)", "meta": {"id": "tell"}}],
     "ports": [{"name": "full", "when": "res.count >= 3", "to": "Bad", "meta": {"id": "full"}},
               {"name": "off", "when": "svc.t.off", "to": "Bad"}]},
    {"state": "Bad", "results": [{"name": "x"}],
     "actions": [{"when": "svc.t.divide", "do": "res.x = 1 / svc.t.divide"}]}]}})json";

using Kind = Goal::Kind;

struct WatchedStepsTest : testing::Test {
  WatchedStepsTest() { execution.start({}); }
  static Execution make() {
    const auto native = rcm::translate(rcm::read_document_text(kWatchedModel).value()).value();
    return Execution::create(semantics::Program::build(native, {}).value(), {}).value();
  }
  const semantics::Program& program() const { return execution.run().program(); }
  void stop_at(std::vector<GoalName> names) {
    std::vector<Goal> goals;
    for (const GoalName& name : names) {
      const auto goal = find_goal(program(), name);
      ASSERT_TRUE(goal) << goal.error().message;
      goals.push_back(*goal);
    }
    execution.set_breakpoints(goals);
  }
  Progress event(const char* name, Value data = Value()) {
    execution.post_event("t", name, std::move(data));
    return execution.step({});
  }
  Value count() {
    const auto& work = program()[*program().find_state("R/Work")];
    return execution.run().state().values[work.first_result];
  }
  bool is_active(const char* path) { return execution.run().is_active(*program().find_state(path)); }
  Execution execution = make();
};

TEST_F(WatchedStepsTest, APortIsTestedWhenSomethingThatItsStateReadsHasChanged) {
  stop_at({{.kind = Kind::tested, .id = "full"}});
  const Progress tested = event("tick");
  EXPECT_TRUE(tested.reached_goal);
  EXPECT_EQ(tested.breakpoints, std::vector<std::uint32_t>{0});
  while (execution.is_open()) execution.continue_step();
  execution.set_breakpoints({});
  event("divide");  // an action that has been executed may be executed again: it is tried once more
  stop_at({{.kind = Kind::tested, .id = "full"}});
  EXPECT_FALSE(event("divide").reached_goal) << "Work reads nothing of it";
}

TEST_F(WatchedStepsTest, ATestInTheMicroStepThatChangesNothingEndsTheMacroStepPaused) {
  stop_at({{.kind = Kind::tested, .id = "full"}});
  event("tick");
  Progress last;
  while (execution.is_open()) last = execution.continue_step();
  EXPECT_TRUE(last.complete);
  EXPECT_TRUE(last.reached_goal) << "after `res.count` has changed, the condition is tested, and does not hold";
}

TEST_F(WatchedStepsTest, StopsBeforeATestWithNothingDone) {
  stop_at({{.kind = Kind::tested, .path = "R/Work.full", .before = true}});
  const Progress before = event("tick");
  EXPECT_TRUE(before.reached_goal);
  EXPECT_EQ(before.micro, 0U);
  EXPECT_TRUE(execution.is_open());
  EXPECT_EQ(count(), Value(0));
  EXPECT_TRUE(before.begins);
  const Progress after = execution.continue_step();
  EXPECT_EQ(after.micro, 1U) << "the same stop does not come twice";
  EXPECT_FALSE(after.begins) << "its entry would be told, and stored, twice";
  EXPECT_EQ(count(), Value(1));
}

TEST_F(WatchedStepsTest, AnActionIsExecuted) {
  stop_at({{.kind = Kind::executed, .id = "tell"}});
  EXPECT_FALSE(event("tick").reached_goal) << "only `count` is executed";
  EXPECT_TRUE(event("tick").reached_goal);
  while (execution.is_open()) execution.continue_step();
  stop_at({{.kind = Kind::executed, .path = "R/Bad"}});
  EXPECT_FALSE(event("tick").reached_goal) << "it is an action of another state";
  EXPECT_TRUE(event("divide", 4).reached_goal);
}

TEST_F(WatchedStepsTest, AnOperationIsCalled) {
  stop_at({{.kind = Kind::called, .service = "lamp", .operation = "set"}});
  EXPECT_FALSE(event("tick").reached_goal);
  const Progress called = event("tick");
  EXPECT_TRUE(called.reached_goal);
  ASSERT_EQ(called.calls.size(), 1U);
}

TEST_F(WatchedStepsTest, StopsBeforeACallThatIsNotMadeThen) {
  event("tick");
  stop_at({{.kind = Kind::called, .before = true, .service = "lamp"}});
  const Progress before = event("tick");
  EXPECT_TRUE(before.reached_goal);
  EXPECT_TRUE(before.calls.empty());
  EXPECT_EQ(count(), Value(1));
  EXPECT_EQ(execution.continue_step().calls.size(), 1U);
}

TEST_F(WatchedStepsTest, StopsBeforeAFaultWhileTheRunIsStillRunning) {
  event("off");
  stop_at({{.kind = Kind::fault}});
  EXPECT_FALSE(event("divide", 2).reached_goal);
  const Progress before = event("divide", 0);
  EXPECT_TRUE(before.reached_goal);
  EXPECT_FALSE(execution.is_over());
  execution.continue_step();
  EXPECT_EQ(execution.run().status(), semantics::Status::faulted);
}

TEST_F(WatchedStepsTest, AFaultIsThatOfTheStateOrOfOneWithinIt) {
  event("off");
  stop_at({{.kind = Kind::fault, .path = "R/Work"}});
  EXPECT_FALSE(event("divide", 0).reached_goal);
  EXPECT_TRUE(execution.is_over());
}

TEST_F(WatchedStepsTest, AConditionBecomesFulfilled) {
  stop_at({{.kind = Kind::fulfilled, .path = "R/Work", .condition = "res.count == 2"}});
  EXPECT_FALSE(event("tick").reached_goal);
  EXPECT_TRUE(event("tick").reached_goal);
  EXPECT_EQ(count(), Value(2));
  while (execution.is_open()) EXPECT_FALSE(execution.continue_step().reached_goal) << "it is fulfilled already";
}

TEST_F(WatchedStepsTest, AConditionMustHoldAsWell) {
  stop_at({{.kind = Kind::executed, .id = "count", .condition = "res.count == 2"},
           {.kind = Kind::executed, .id = "count", .before = true, .condition = "res.count == 2"}});
  EXPECT_FALSE(event("tick").reached_goal);
  EXPECT_EQ(event("tick").breakpoints, std::vector<std::uint32_t>{0}) << "after: it holds after the action";
  while (execution.is_open()) execution.continue_step();
  EXPECT_EQ(event("tick").breakpoints, std::vector<std::uint32_t>{1}) << "before: it holds before the next one";
  EXPECT_EQ(count(), Value(2));
}

TEST_F(WatchedStepsTest, StopsBeforeAStateIsEnteredAndOneIsLeft) {
  stop_at({{.kind = Kind::entered, .path = "R/Bad", .before = true},
           {.kind = Kind::left, .path = "R/Work", .before = true}});
  EXPECT_EQ(event("off").breakpoints, std::vector<std::uint32_t>{1});
  EXPECT_TRUE(is_active("R/Work"));
  EXPECT_EQ(execution.continue_step().breakpoints, std::vector<std::uint32_t>{0});
  EXPECT_FALSE(is_active("R/Work"));
  EXPECT_FALSE(is_active("R/Bad"));
  execution.continue_step();
  EXPECT_TRUE(is_active("R/Bad"));
}

TEST_F(WatchedStepsTest, IntoAStateIsAStateWithinItOrItsEnd) {
  stop_at({{.kind = Kind::into, .path = "R"}});
  EXPECT_FALSE(event("tick").reached_goal);
  EXPECT_FALSE(execution.is_open());
  const Progress entered = event("off");
  EXPECT_TRUE(entered.reached_goal);
  EXPECT_TRUE(is_active("R/Bad"));
  stop_at({{.kind = Kind::into, .path = "R/Bad"}});
  while (execution.is_open()) EXPECT_FALSE(execution.continue_step().reached_goal) << "it has none within it";
}

TEST_F(WatchedStepsTest, AStopStaysThatOfTheBreakpointsThatAreSetAnew) {
  const std::vector<GoalName> names = {{.kind = Kind::entered, .path = "R/Bad", .before = true}};
  stop_at(names);
  Progress last = event("off");
  while (!last.reached_goal) last = execution.continue_step();
  stop_at(names);
  EXPECT_FALSE(execution.continue_step().reached_goal);
  EXPECT_TRUE(is_active("R/Bad"));
}

TEST_F(WatchedStepsTest, WhatIsRecordedIsTheSameWithAndWithoutBreakpoints) {
  Execution other = make();
  other.start({});
  stop_at({{.kind = Kind::tested, .id = "full", .before = true}, {.kind = Kind::executed, .id = "count"}});
  for (int i = 0; i < 3; ++i) {
    execution.post_event("t", "tick", Value());
    Progress part = execution.step({.derivation = true});
    List parts = micro_steps_json(program(), *part.derivation);
    while (!part.complete) {
      part = execution.continue_step();
      for (const Value& tree : micro_steps_json(program(), *part.derivation)) parts.push_back(tree);
    }
    other.post_event("t", "tick", Value());
    EXPECT_EQ(Value(parts), Value(micro_steps_json(program(), *other.step({.derivation = true}).derivation)));
    EXPECT_EQ(execution.micro_steps(), other.micro_steps());
    EXPECT_EQ(execution.run().state_json(), other.run().state_json());
  }
}

TEST_F(WatchedStepsTest, NamesWhatTheProgramHas) {
  const auto refused = [&](const GoalName& name) { return find_goal(program(), name).error(); };
  EXPECT_EQ(refused({.kind = Kind::executed, .path = "R/Work/In"}).path, "path") << "it has no actions";
  EXPECT_EQ(refused({.kind = Kind::executed, .id = "no"}).path, "id");
  EXPECT_EQ(refused({.kind = Kind::tested, .path = "R/Work"}).code, ErrorCode::not_found);
  EXPECT_EQ(refused({.kind = Kind::called, .service = "lamp", .operation = "get"}).path, "operation");
  EXPECT_EQ(refused({.kind = Kind::called, .path = "R/Bad", .service = "lamp"}).code, ErrorCode::not_found);
  const Error unread = refused({.kind = Kind::entered, .path = "R/Bad", .condition = "svc.t.never"});
  EXPECT_EQ(unread.code, ErrorCode::unknown_name);
  EXPECT_EQ(unread.path, "condition");
  EXPECT_EQ(refused({.kind = Kind::entered, .path = "R/Bad", .condition = "res.none == 1"}).code,
            ErrorCode::unknown_name);
  EXPECT_EQ(refused({.kind = Kind::entered, .path = "R/Bad", .condition = "1 +"}).code, ErrorCode::syntax);
}

}  // namespace
}  // namespace race::execution
