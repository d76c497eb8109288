// Where an execution stops: goals, and breakpoints, which are goals that stay.
#include "core/execution/goal.h"

#include <gtest/gtest.h>

#include "core/execution/execution.h"
#include "core/rcm/document.h"
#include "core/rcm/translate.h"

namespace race::execution {
namespace {

// A and B follow one another on every event; B passes through C.
constexpr const char* kGoalModel = R"json({"rcm": 1, "root": {"state": "R", "first": "A", "children": [
  {"state": "A", "ports": [{"name": "go", "when": "svc.t.a", "to": "B"}]},
  {"state": "B", "ports": [{"name": "go", "when": "svc.t.a", "to": "C", "meta": {"id": "b-go"}}], "meta": {"id": "b"}},
  {"state": "C", "ports": [{"name": "go", "when": "True", "to": "A"}]}]}})json";

struct GoalTest : testing::Test {
  GoalTest() { execution.start({}); }
  static Execution make() {
    const auto native = rcm::translate(rcm::read_document_text(kGoalModel).value()).value();
    return Execution::create(semantics::Program::build(native, {}).value(), {}).value();
  }
  Goal goal(Goal::Kind kind, const char* path) {
    return find_goal(execution.run().program(), {kind, {}, path}).value();
  }
  Progress event() {
    execution.post_event("t", "a", {});
    return execution.step({});
  }
  std::string active() {
    std::string out;
    for (const char* path : {"R/A", "R/B", "R/C"})
      if (execution.run().is_active(*execution.run().program().find_state(path))) out += path;
    return out;
  }
  Execution execution = make();
};

TEST_F(GoalTest, StopsWithinAMacroStepWhereAStateIsEnteredAndGoesOnFromThere) {
  event();
  execution.set_goal(goal(Goal::Kind::entered, "R/C"));
  const Progress held = event();
  EXPECT_TRUE(held.reached_goal);
  EXPECT_FALSE(held.complete);
  EXPECT_TRUE(execution.is_open());
  EXPECT_EQ(active(), "R/C");
  EXPECT_FALSE(execution.has_goal()) << "a goal is given up when it is reached";
  const Progress rest = execution.continue_step();
  EXPECT_TRUE(rest.complete);
  EXPECT_FALSE(rest.reached_goal);
  EXPECT_EQ(active(), "R/A");
}

TEST_F(GoalTest, StopsWhereAStateIsLeftAlsoIfItBeginsAfterwards) {
  execution.set_goal(goal(Goal::Kind::left, "R/A"));
  EXPECT_TRUE(event().reached_goal);
  EXPECT_EQ(active(), "");
  execution.continue_step();
  EXPECT_EQ(active(), "R/B");
  execution.set_goal(goal(Goal::Kind::left, "R/A"));
  EXPECT_FALSE(event().reached_goal) << "A was entered, not left";
  EXPECT_TRUE(event().reached_goal);
}

TEST_F(GoalTest, StopsWhereAPortFires) {
  execution.set_goal(goal(Goal::Kind::fired, "R/C.go"));
  EXPECT_FALSE(event().reached_goal);
  EXPECT_TRUE(event().reached_goal);
  EXPECT_EQ(active(), "");
}

TEST_F(GoalTest, OfAMicroOrMacroStepIsReachedAfterIt) {
  event();
  execution.set_goal(Goal{.kind = Goal::Kind::micro});
  const Progress micro = event();
  EXPECT_TRUE(micro.reached_goal);
  EXPECT_EQ(micro.micro, 1U);
  execution.set_goal(Goal{.kind = Goal::Kind::macro});
  const Progress rest = execution.continue_step();
  EXPECT_TRUE(rest.reached_goal);
  EXPECT_TRUE(rest.complete);
}

TEST_F(GoalTest, ThatIsABreakpointStaysAndEndsTheStepToAnother) {
  execution.set_breakpoints({goal(Goal::Kind::entered, "R/C")});
  execution.set_goal(goal(Goal::Kind::entered, "R/A"));
  EXPECT_FALSE(event().reached_goal);
  EXPECT_TRUE(event().reached_goal);
  EXPECT_EQ(active(), "R/C");
  EXPECT_FALSE(execution.has_goal());
  EXPECT_FALSE(execution.continue_step().reached_goal);
  EXPECT_FALSE(event().reached_goal);
  EXPECT_TRUE(event().reached_goal) << "again";
  execution.set_breakpoints({});
  execution.continue_step();
  EXPECT_FALSE(event().reached_goal);
  EXPECT_FALSE(event().reached_goal);
}

TEST_F(GoalTest, NamesAStateOrPortThatTheProgramHas) {
  const semantics::Program& program = execution.run().program();
  EXPECT_EQ(find_goal(program, {Goal::Kind::entered, "b", ""}), goal(Goal::Kind::entered, "R/B"));
  EXPECT_EQ(find_goal(program, {Goal::Kind::fired, "b-go", ""}), goal(Goal::Kind::fired, "R/B.go"));
  EXPECT_EQ(find_goal(program, {Goal::Kind::fired, "b", ""}).error().code, ErrorCode::not_found);
  EXPECT_EQ(find_goal(program, {Goal::Kind::entered, "R/B", ""}).error().code, ErrorCode::not_found);
  EXPECT_EQ(find_goal(program, {Goal::Kind::entered, {}, "R/X"}).error().code, ErrorCode::not_found);
  EXPECT_EQ(find_goal(program, {Goal::Kind::fired, {}, "R/A"}).error().code, ErrorCode::not_found);
  EXPECT_EQ(find_goal(program, {Goal::Kind::left, {}, "R/A.go"}).error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace race::execution
