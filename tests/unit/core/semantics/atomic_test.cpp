// The atomic layer: parameters, conditions, functions, actions, and which response a state reads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/semantics/small_runs.h"

namespace race::semantics {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Resolve, SeesTheParentNotTheSiblings) {
  SmallRun run(R"({'state': 'R', 'parameters': [{'name': 'p', 'value': 2}], 'first': 'A',
    'children': [{'state': 'A', 'parameters': [{'name': 'q', 'from': 'par.p * 3'}, {'name': 'p', 'from': 'par.p'}]}]})",
               {{"p", 7}});
  run.step();
  EXPECT_EQ(run.get("parameters", "R/A", "q"), Value(21));
  EXPECT_EQ(run.get("parameters", "R/A", "p"), Value(7));
}

TEST(Resolve, FaultsWithoutAValueAtTheStateThatOwnsTheParameter) {
  SmallRun run(R"({'state': 'R', 'results': [{'name': 'r'}], 'first': 'A',
    'children': [{'state': 'A', 'parameters': [{'name': 'q', 'from': 'res.r'}]}]})");
  EXPECT_THAT(run.step(), IsEmpty());
  ASSERT_TRUE(run->fault());
  EXPECT_EQ(run->fault()->kind, language::FaultKind::unresolved);
  EXPECT_EQ(run->fault()->at, "R/A");
  EXPECT_EQ(run.active(), "");
}

TEST(Action1, RunsOnceInEveryMacroStepInWhichItsConditionHolds) {
  SmallRun run(R"({'state': 'R', 'variables': [{'name': 'v', 'initial': 0}],
    'actions': [{'when': 'True', 'do': 'var.v += 1'}], 'ports': [{'name': 'p', 'when': 'svc.t.a.x > 9'}]})");
  EXPECT_THAT(run.step(), ElementsAre("SAct1 R", "SProp R, Action1 R#0"));
  EXPECT_THAT(run.event("a"), ElementsAre("SProp R, Action1 R#0"));
  EXPECT_EQ(run.get("variables", "R", "v"), Value(2));
}

// 3.16 `executed` belongs to the macro step, not to the activation.
TEST(Action1, DoesNotRunAgainInTheSameMacroStepThoughItsStateIsEnteredAgain) {
  SmallRun run(R"({'state': 'R', 'variables': [{'name': 'v', 'initial': 0}], 'first': 'A', 'children': [
    {'state': 'A', 'results': [{'name': 'n', 'initial': 0}], 'actions': [{'when': 'True', 'do': 'res.n = 1'}],
     'ports': [{'name': 'p', 'when': 'res.n == 1', 'to': 'A'}]}]})");
  EXPECT_THAT(run.step(), ElementsAre("SAct1 R, SAct1 A", "SProp R, SProp A, Action1 A#0",
                                      "SProp R, PTrigger A.p, SDeact2 A", "PTrans1 R, SAct1 A"));
  EXPECT_EQ(run.get("results", "R/A", "n"), Value(0));
}

constexpr const char* kCommand = R"({'state': 'R', 'actions': [{'when': '%', 'do': 'svc.t.f()'}],
    'ports': [{'name': 'p', 'when': 'svc.t.b.x > 9 and svc.t.s'}]})";

std::string command_when(std::string_view condition) {
  std::string model = kCommand;
  return model.replace(model.find('%'), 1, condition);
}

TEST(Action2, HoldsBackACommandUntilWhatItsConditionMentionsComesAnew) {
  SmallRun run(command_when("svc.t.a.x > 0"));
  run.step();
  EXPECT_THAT(run.event("a", 1), ElementsAre("SProp R, Action1 R#0"));
  EXPECT_THAT(run.event("b"), IsEmpty());
  EXPECT_THAT(run.event("a", 1), ElementsAre("SProp R, Action1 R#0"));
  EXPECT_THAT(run.calls(), ElementsAre("t.f()#1", "t.f()#2"));
}

TEST(Action2, IsNotUndoneByLatestWhichMentionsNothing) {
  SmallRun run(command_when("svc.t.a.latest.x > 0"));
  run.step();
  EXPECT_THAT(run.event("a", 1), ElementsAre("SProp R, Action1 R#0"));
  EXPECT_THAT(run.event("a", 2), IsEmpty());  // the level still holds
  EXPECT_THAT(run.event("a", 0), IsEmpty());  // it falls
  EXPECT_THAT(run.event("a", 1), ElementsAre("SProp R, Action1 R#0"));
}

TEST(Action2, EndsWithTheActivationOfItsState) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [
    {'state': 'A', 'actions': [{'when': 'True', 'do': 'svc.t.f()'}],
     'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'A'}]}]})");
  run.step();
  run.event("a");  // entered again: commands again
  EXPECT_THAT(run.calls(), ElementsAre("t.f()#1", "t.f()#2"));
}

TEST(Action3, LeavesNothingOfAnUnmetFunction) {
  SmallRun run(R"({'state': 'R', 'variables': [{'name': 'v', 'initial': 0}],
    'actions': [{'when': 'svc.t.a', 'do': 'var.v = 1\nsvc.t.f()\nvar.v = svc.t.s.x'}]})");
  run.step();
  EXPECT_THAT(run.event("a"), IsEmpty());
  EXPECT_EQ(run.get("variables", "R", "v"), Value(0));
  EXPECT_THAT(run.calls(), IsEmpty());
  run.event("s", 5);
  EXPECT_THAT(run.event("a"), ElementsAre("SProp R, Action1 R#0"));
  EXPECT_EQ(run.get("variables", "R", "v"), Value(5));
  EXPECT_THAT(run.calls(), ElementsAre("t.f()#1"));
}

TEST(Func, DoesNotSeeTheOldResponseAfterItsOwnCall) {
  SmallRun run(R"({'state': 'R', 'variables': [{'name': 'before'}, {'name': 'after'}], 'entry': 'svc.t.f()',
    'actions': [{'when': 'svc.t.a',
      'do': 'var.before = available(svc.t.f.result)\nsvc.t.f()\nvar.after = available(svc.t.f.result)'}]})");
  run.step();
  run.result(1, 4);
  run.event("a");
  EXPECT_EQ(run.get("variables", "R", "before"), Value(true));
  EXPECT_EQ(run.get("variables", "R", "after"), Value(false));
}

// Two siblings that call the same operation, and what reads its response where (R6, R20).
constexpr const char* kCallers = R"({'state': 'R', 'variables': [{'name': 'v'}], 'first': 'b', 'children': [
    {'barrier': 'b', 'to': ['A', 'B', 'C']},
    {'state': 'A', 'results': [{'name': 'r'}], 'entry': 'svc.t.f(1)',
     'actions': [{'when': 'svc.t.f.result', 'do': 'res.r = svc.t.f.result'}],
     'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'A'}]},
    {'state': 'B', 'results': [{'name': 'r'}], 'entry': 'svc[\'t\'].f(2)',
     'actions': [{'when': 'svc.t.f.result', 'do': 'res.r = svc.t.f.result'}]},
    {'state': 'C', 'results': [{'name': 'r'}],
     'actions': [{'when': 'svc[\'t\'].f.result', 'do': 'res.r = svc[\'t\'].f.result'}]}]})";

std::string callers() {  // \' is a quote of the function language
  std::string model = kCallers;
  for (auto at = model.find("\\'"); at != std::string::npos; at = model.find("\\'")) model.replace(at, 2, "\\\"");
  return model;
}

TEST(CondBD, ReadsTheResponseToTheCallOfItsOwnState) {
  SmallRun run(callers());
  run.step();
  EXPECT_THAT(run.calls(), ElementsAre("t.f(1)#1", "t.f(2)#2"));
  run.result(1, 10);
  EXPECT_EQ(run.get("results", "R/A", "r"), Value(10));
  EXPECT_TRUE(run.get("results", "R/B", "r").is_unknown());
  run.result(2, 20);
  EXPECT_EQ(run.get("results", "R/A", "r"), Value(10));
  EXPECT_EQ(run.get("results", "R/B", "r"), Value(20));
}

// The numbers of the open calls that these supersede (R20).
std::vector<std::uint64_t> superseded(SmallRun& run) {
  std::vector<std::uint64_t> out;
  for (const OutgoingCall& call : run->take_calls()) out.push_back(call.supersedes);
  return out;
}

TEST(FuncSC, NamesTheOpenCallOfItsCallerThatItSupersedes) {
  SmallRun run(callers());
  run.step();
  EXPECT_THAT(superseded(run), ElementsAre(0, 0)) << "two callers";
  run.event("a");
  EXPECT_THAT(superseded(run), ElementsAre(1)) << "A was left, and calls again";
  run.result(3, 10);
  run.event("a");
  EXPECT_THAT(superseded(run), ElementsAre(0)) << "it has been answered";
  run->post_response(4, false, 10);
  run.step();
  run.event("a");
  run.event("a");
  EXPECT_THAT(superseded(run), ElementsAre(0, 5));
}

TEST(FuncSC, SupersedesNoCallOfAnotherOperationOrService) {
  SmallRun run(R"({'state': 'R', 'parameters': [{'name': 's', 'value': 'x'}],
    'entry': 'svc.t.f()\nsvc.t.g()\nsvc.u.f()\nsvc[par.s].h()\nsvc.y.h()\nsvc.x.h()\nsvc.t.f()'})");
  run.step();
  EXPECT_THAT(superseded(run), ElementsAre(0, 0, 0, 0, 0, 4, 1));
}

// R7: what nobody has declared or named answers `unavailable`, which the caller can read.
TEST(CondBD, ReadsTheErrorOfAServiceThatOnlyAComputedNameNames) {
  SmallRun run(R"({'state': 'R', 'parameters': [{'name': 's', 'value': 'ghost'}], 'entry': 'svc[par.s].haunt(1)',
    'ports': [{'name': 'gone', 'when': 'svc[par.s].haunt.error.code == \'unavailable\''}]})");
  run.step();
  EXPECT_THAT(run.calls(), ElementsAre("ghost.haunt(1)#1"));
  EXPECT_TRUE(run->post_response(1, true, Dict{{"code", "unavailable"}}));
  EXPECT_THAT(run.step(), ElementsAre("PTrigger R.gone, SDeact2 R"));
}

// Two unknown services and one operation: the answer of one is not the answer of the other (R6, R20).
constexpr const char* kGhosts = R"({'state': 'R', 'variables': [{'name': 'other'}], 'first': 'b', 'children': [
    {'barrier': 'b', 'to': ['A', 'B']},
    {'state': 'A', 'results': [{'name': 'r'}], 'entry': 'var.s = \'x\'\nsvc[var.s].f(1)',
     'actions': [{'when': 'svc.t.a', 'do': 'svc[var.s].f(2)'},
                 {'when': 'svc[var.s].f.result', 'do': 'res.r = svc[var.s].f.result'}]},
    {'state': 'B', 'results': [{'name': 'r'}], 'entry': 'var.s = \'y\'\nsvc[var.s].f(3)',
     'actions': [{'when': 'svc[var.s].f.result', 'do': 'res.r = svc[var.s].f.result'}]}],
    'actions': [{'when': 'True', 'do': 'var.other = [available(svc[s].f.result) for s in [\'x\', \'y\', \'z\']]'}]})";

TEST(CondBD, KeepsTheAnswersOfUnknownServicesApart) {
  SmallRun run(kGhosts);
  run.step();
  EXPECT_THAT(run.calls(), ElementsAre("x.f(1)#1", "y.f(3)#2"));
  run.result(2, 20);
  EXPECT_TRUE(run.get("results", "R/A", "r").is_unknown());
  EXPECT_EQ(run.get("results", "R/B", "r"), Value(20));
  EXPECT_EQ(run.get("variables", "R", "other"), Value(List{false, true, false}));
  run.result(1, 10);
  EXPECT_EQ(run.get("results", "R/A", "r"), Value(10));
  EXPECT_EQ(run.get("variables", "R", "other"), Value(List{true, true, false}));
  run.event("a");  // x is called again: its old answer is gone, y's stays
  EXPECT_THAT(run.calls(), ElementsAre("x.f(2)#3"));
  run->post_lost("x");
  run.step();
  EXPECT_EQ(run.get("variables", "R", "other"), Value(List{false, true, false}));
  EXPECT_EQ(run->find_call("x", "f"), 3U);
  EXPECT_EQ(run->find_call("y", "f"), 2U);
  EXPECT_EQ(run->find_call("z", "f"), 0U);
}

TEST(CondBD, ReadsTheResponseToTheLatestCallOfAnyoneWhereNobodyCalls) {
  SmallRun run(callers());
  run.step();
  run.result(1, 10);
  EXPECT_TRUE(run.get("results", "R/C", "r").is_unknown()) << "call 2 is later, and not answered";
  run.result(2, 20);
  EXPECT_EQ(run.get("results", "R/C", "r"), Value(20));
}

TEST(CondBD, ForgetsTheResponseWhenItsStateIsEnteredAgain) {
  SmallRun run(callers());
  run.step();
  run.result(1, 10);
  run.event("a");
  EXPECT_TRUE(run.get("results", "R/A", "r").is_unknown());
  EXPECT_THAT(run.result(1, 11), IsEmpty()) << "only the latest call of a caller can be answered";
  run.result(3, 30);
  EXPECT_EQ(run.get("results", "R/A", "r"), Value(30));
}

TEST(CondBD, ReadsNoResponseToACallOfAnEarlierActivation) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [{'state': 'A', 'results': [{'name': 'r'}],
    'actions': [{'when': 'svc.t.b', 'do': 'svc.t.f()'}, {'when': 'svc.t.f.result', 'do': 'res.r = svc.t.f.result'}],
    'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'A'}]}]})");
  run.step();
  run.event("b");
  run.result(1, 10);
  EXPECT_EQ(run.get("results", "R/A", "r"), Value(10));
  run.event("a");
  EXPECT_TRUE(run.get("results", "R/A", "r").is_unknown());
}

TEST(CondBD, CountsTheCallsOfDescendants) {
  SmallRun run(R"({'state': 'R', 'results': [{'name': 'r'}], 'first': 'b',
    'actions': [{'when': 'svc.t.f.result', 'do': 'res.r = svc.t.f.result'}], 'children': [
    {'barrier': 'b', 'to': ['A', 'B']},
    {'state': 'A', 'first': 'D', 'results': [{'name': 'r'}],
     'actions': [{'when': 'svc.t.f.result', 'do': 'res.r = svc.t.f.result'}],
     'children': [{'state': 'D', 'entry': 'svc.t.f(1)'}]},
    {'state': 'B', 'entry': 'svc.t.f(2)'}]})");
  run.step();
  run.result(1, 10);
  EXPECT_EQ(run.get("results", "R/A", "r"), Value(10));
  EXPECT_TRUE(run.get("results", "R", "r").is_unknown()) << "the latest call below R is B's";
}

}  // namespace
}  // namespace race::semantics
