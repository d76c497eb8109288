// Runs: the order of inputs, quiescence, the end, faults, copies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/semantics/small_runs.h"

namespace race::semantics {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Notes the inputs that it sees.
constexpr const char* kListener =
    R"({'state': 'R', 'variables': [{'name': 'seen', 'initial': ''}], 'entry': 'svc.t.f()',
  'actions': [{'when': 'svc.t.a', 'do': 'var.seen += \"a\" + str(svc.t.a.x)'},
              {'when': 'svc.t.s', 'do': 'var.seen += \"s\" + str(svc.t.s.x)'},
              {'when': 'svc.t.f.error', 'do': 'var.seen += svc.t.f.error.code'}]})";

Value datum(int x) { return Dict{{"x", x}}; }

TEST(Macro, TakesInputsInOrderOfArrivalAndOfASampledEventTheNewestAtTheEnd) {
  SmallRun run(kListener);
  run->post_event("t", "s", datum(1));
  run->post_event("t", "a", datum(1));
  run->post_event("t", "a", datum(2));
  run->post_event("t", "s", datum(2));
  run->post_event("t", "a", datum(3));
  run.step();
  EXPECT_EQ(run.get("variables", "R", "seen"), Value("a1")) << "the first input belongs to the first macro step";
  while (run->has_input()) run.step();
  EXPECT_EQ(run.get("variables", "R", "seen"), Value("a1a2s2a3"));
}

TEST(Macro, DropsWhatTheModelNowhereNames) {
  SmallRun run(kListener);
  run.step();
  EXPECT_FALSE(run->post_event("t", "b", {}));
  EXPECT_FALSE(run->post_event("u", "a", {}));
  EXPECT_FALSE(run->post_response(2, false, {})) << "there is no call 2";
}

TEST(Macro, AnswersUnansweredCallsToALostServiceAndACallOnlyOnce) {
  SmallRun run(kListener);
  run.step();
  run->post_response(1, true, Dict{{"code", "late"}});
  run->post_lost("t");
  while (run->has_input()) run.step();
  EXPECT_EQ(run.get("variables", "R", "seen"), Value("late"));
  EXPECT_FALSE(run->post_response(1, true, {}));
}

TEST(Macro, WithoutInputChangesNothing) {
  SmallRun run(kListener);
  run.event("a", 1);
  EXPECT_THAT(run.step(), IsEmpty());
  EXPECT_EQ(run.get("variables", "R", "seen"), Value("a1")) << "Σ' = Σ: the action has been executed in it";
}

// n states in a row: 1 micro step to begin with, 2 for each transition.
SmallRun chain(int n, std::uint32_t allowed) {
  std::string children;
  for (int i = 0; i <= n; ++i) {
    children += (i ? ", " : "") + std::string("{'state': 'S") + std::to_string(i) + "'";
    if (i < n) children += ", 'ports': [{'name': 'p', 'when': 'True', 'to': 'S" + std::to_string(i + 1) + "'}]";
    children += "}";
  }
  Budgets budgets;
  budgets.micro_steps = allowed;
  return SmallRun("{'state': 'R', 'first': 'S0', 'children': [" + children + "]}", {}, budgets);
}

TEST(Macro, MayTakeExactlyAsManyMicroStepsAsTheBudgetAllows) {
  EXPECT_EQ(Budgets().micro_steps, 10'000u);
  SmallRun enough = chain(5, 11);
  EXPECT_EQ(enough.step().size(), 11u);
  EXPECT_EQ(enough->status(), Status::running);
  SmallRun short_of_one = chain(5, 10);
  EXPECT_EQ(short_of_one.step().size(), 10u);
  ASSERT_EQ(short_of_one->status(), Status::faulted);
  EXPECT_EQ(short_of_one->fault()->kind, language::FaultKind::divergence);
  EXPECT_EQ(short_of_one->fault()->at, "R");
  EXPECT_EQ(short_of_one.active(), "R");
  EXPECT_EQ(to_json(*short_of_one->state_json().find("ports")), R"(["R/S4.p"])") << "as after the tenth";
}

TEST(Micro, EndsTheRunWithThePortByWhichTheRootIsLeft) {
  SmallRun run(
      R"({'state': 'R', 'first': 'A', 'ports': [{'name': 'p', 'when': 'False'}, {'name': 'q', 'when': 'svc.t.a'}],
    'exit': 'svc.t.g()', 'children': [{'state': 'A', 'exit': 'svc.t.f()'}]})");
  run.step();
  EXPECT_THAT(run.event("a"), ElementsAre("PTrigger R.q, SDeact2 R, SDeact2 A"));
  EXPECT_EQ(run->status(), Status::ended);
  EXPECT_EQ(run->outcome(), "q");
  EXPECT_THAT(run.calls(), ElementsAre("t.f()#1", "t.g()#2"));
  EXPECT_EQ(to_json(*run->state_json().find("ports")), R"(["R.q"])");
  EXPECT_FALSE(run->post_event("t", "a", {}));
}

// Calls u, then t; a fault comes with a, in a micro step that would have called v for the first time.
constexpr const char* kFaulty =
    R"({'state': 'R', 'variables': [{'name': 'v', 'initial': 0}], 'entry': 'svc.u.f()\nsvc.t.f()',
  'actions': [{'when': 'svc.t.a', 'do': 'var.v = 1\nsvc.v.f()'}, {'when': 'svc.t.a', 'do': 'var.v = 1 // 0'}]})";

TEST(Micro, DiscardsAFaultyStepAndCallsWhatIsSafeOfTheServicesCalledInCompleteSteps) {
  SmallRun run(kFaulty);
  run.step();
  EXPECT_THAT(run.calls(), ElementsAre("u.f()#1", "t.f()#2"));
  EXPECT_THAT(run.event("a"), IsEmpty());
  EXPECT_EQ(run->status(), Status::faulted);
  EXPECT_EQ(run.get("variables", "R", "v"), Value(0));
  // In order of first call, operations as declared; the number of the discarded call is free again.
  EXPECT_THAT(run.calls(), ElementsAre("u.off()#3", "u.halt()#4", "t.off()#5", "t.halt()#6"));
}

TEST(Run, ShowsTheResponsesOfTheLastCompleteStepAfterAFault) {
  SmallRun run(R"({'state': 'R', 'entry': 'svc.t.f()',
    'actions': [{'when': 'svc.t.a', 'do': 'svc.t.f()\nvar.v = 1 // 0'}], 'ports': [{'name': 'p', 'when': 'svc.t.f.result and svc.t.b'}]})");
  run.step();
  run.result(1, 5);
  run.event("a");
  ASSERT_EQ(run->status(), Status::faulted);
  const auto why = std::get<WhyPort>(run->why(PortId{0}));
  ASSERT_EQ(why.explanation.atoms.size(), 2u);
  EXPECT_EQ(why.explanation.atoms[0].value, language::Truth::yes);
}

TEST(Run, IsAValueACopyGoesOnByItself) {
  SmallRun run(kListener);
  run.event("a", 1);
  SmallRun copy = run;
  run.event("a", 2);
  EXPECT_EQ(copy.get("variables", "R", "seen"), Value("a1"));
  copy.event("a", 3);
  EXPECT_EQ(run.get("variables", "R", "seen"), Value("a1a2"));
  EXPECT_EQ(copy.get("variables", "R", "seen"), Value("a1a3"));
}

}  // namespace
}  // namespace race::semantics
