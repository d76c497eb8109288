// The micro layer: what one state does in one micro step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/semantics/small_runs.h"

namespace race::semantics {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(PTrigger, TakesTheFirstFulfilledPortInOrder) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [{'state': 'A', 'ports': [
    {'name': 'p', 'when': 'svc.t.a.x > 5'}, {'name': 'q', 'when': 'svc.t.a'}, {'name': 'r', 'when': 'svc.t.a'}]}]})");
  run.step();
  EXPECT_THAT(run.event("a"), ElementsAre("SProp R, PTrigger A.q, SDeact2 A"));
}

TEST(PTrigger, DoesNotSeeTheOccurrenceThatActivatedItsState) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [
    {'state': 'A', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'B'}]},
    {'state': 'B', 'results': [{'name': 'x'}], 'actions': [{'when': 'available(svc.t.a)', 'do': 'res.x = svc.t.a.x'}],
     'ports': [{'name': 'p', 'when': 'available(svc.t.a)', 'to': 'C'}]},
    {'state': 'C'}]})");
  run.step();
  run.event("a", 4);
  EXPECT_EQ(run.active(), "R B");
  EXPECT_EQ(run.get("results", "R/B", "x"), Value(4)) << "its action does see it";
  run.event("a");
  EXPECT_EQ(run.active(), "R C");
}

TEST(PTrigger, SeesTheDataOfASampledEventAtOnceButNotItsOccurrence) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [
    {'state': 'A', 'ports': [{'name': 'p', 'when': 'svc.t.s', 'to': 'B'}]},
    {'state': 'B', 'ports': [{'name': 'p', 'when': 'svc.t.s', 'to': 'D'}, {'name': 'q', 'when': 'svc.t.s.x == 1', 'to': 'C'}]},
    {'state': 'C'}, {'state': 'D'}]})");
  run.step();
  run.event("s", 1);
  EXPECT_EQ(run.active(), "R C");
}

// A and B alternate; the response stays latched. `first` is A's first port, `second` the one after it.
std::string alternating(const std::string& first, const std::string& second) {
  return R"({'state': 'R', 'entry': 'svc.t.f()', 'first': 'A', 'variables': [{'name': 'n', 'initial': 0}], 'children': [
    {'state': 'A', 'parameters': [{'name': 'n', 'from': 'var.n'}], 'ports': [
      {'name': 'p', 'when': ')" +
         first + R"(', 'to': 'B'}, {'name': 'q', 'when': ')" + second + R"(', 'to': 'C'}]},
    {'state': 'B', 'ports': [{'name': 'back', 'when': 'True', 'to': 'A'}]}, {'state': 'C'}],
    'actions': [{'when': 'chi.B.active', 'do': 'var.n = 1'}]})";
}

TEST(PTrigger, FiresAPortThatMentionsSvcOnceInAMacroStepAndHoldsBackThoseAfterIt) {
  SmallRun run(alternating("svc.t.f.result", "par.n == 1"));
  run.step();
  run.result(1, 0);
  EXPECT_EQ(run.active(), "R A") << "p holds back q, which is fulfilled too";
  run->begin(std::nullopt);
  NoRecorder nothing;
  EXPECT_FALSE(run->micro(nothing)) << "Σ is the same";
}

TEST(PTrigger, HoldsBackNoPortBeforeTheOneThatHasFired) {
  SmallRun run(alternating("par.n == 1", "svc.t.f.result"));
  run.step();
  EXPECT_THAT(run.result(1, 0), ElementsAre("SProp R, PTrigger A.q, SDeact2 A", "PTrans1 R, SAct1 C"));
}

TEST(PTrans1, TakesItsListOnceThoughAnActivationClearsAPortOfIt) {
  SmallRun run(R"({'state': 'R', 'first': 'b', 'children': [
    {'barrier': 'b', 'to': ['A', 'B']},
    {'state': 'A', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'B'}]},
    {'state': 'B', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'C'}]}, {'state': 'C'}]})");
  run.step();
  EXPECT_THAT(run.event("a"),
              ElementsAre("SProp R, PTrigger A.p, SDeact2 A, PTrigger B.p, SDeact2 B", "PTrans1 R, SAct1 B, SAct1 C"));
  EXPECT_EQ(run.active(), "R B C");
  EXPECT_EQ(to_json(*run->state_json().find("ports")), "[]");
}

TEST(PTrans1, EntersAStateAnewThroughAPortToItself) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [{'state': 'A', 'variables': [{'name': 'v', 'initial': 0}],
    'actions': [{'when': 'svc.t.b', 'do': 'var.v += 1'}], 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'A'}]}]})");
  run.step();
  run.event("b");
  EXPECT_THAT(run.event("a"), ElementsAre("SProp R, PTrigger A.p, SDeact2 A", "PTrans1 R, SAct1 A"));
  EXPECT_EQ(run.get("variables", "R/A", "v"), Value(0));
  EXPECT_THAT(run.event("a"), ElementsAre("SProp R, PTrigger A.p, SDeact2 A", "PTrans1 R, SAct1 A"));
}

// R23: D's parameter is resolved before C's entry could change anything, and once for both ports.
TEST(PTrans1, ResolvesTheParametersOfAllTargetsBeforeItEntersOne) {
  SmallRun run(R"({'state': 'R', 'first': 'b', 'children': [
    {'barrier': 'b', 'to': ['A', 'B', 'E']},
    {'state': 'A', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'C'}]},
    {'state': 'B', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'D'}]},
    {'state': 'E', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'D'}]},
    {'state': 'C', 'results': [{'name': 'r', 'initial': 0}], 'entry': 'res.r = 1'},
    {'state': 'D', 'parameters': [{'name': 'q', 'from': 'chi.C.res.r'}]}]})");
  run.step();
  EXPECT_THAT(run.event("a"),
              ElementsAre("SProp R, PTrigger A.p, SDeact2 A, PTrigger B.p, SDeact2 B, PTrigger E.p, SDeact2 E",
                          "PTrans1 R, SAct1 C, SAct1 D, SAct2 D"));
  EXPECT_EQ(run.get("parameters", "R/D", "q"), Value(0));
}

TEST(PTrans2, ExecutesTheActionsBeforeTheParametersOfItsTargetsAreResolved) {
  SmallRun run(R"({'state': 'R', 'first': 'b', 'variables': [{'name': 'v', 'initial': 0}],
    'actions': [{'when': 'chi.b', 'do': 'var.v = 1'}], 'children': [
    {'barrier': 'b', 'to': ['A']}, {'state': 'A', 'parameters': [{'name': 'q', 'from': 'var.v'}]}]})");
  EXPECT_THAT(run.step(), ElementsAre("SAct1 R, BAct1 b", "PTrans2 R, Action1 R#0, SAct1 A, BDeact b"));
  EXPECT_EQ(run.get("parameters", "R/A", "q"), Value(1));
}

TEST(SProp, ComesToTheChildrenAfterItsOwnActionsWhichSeeThemInTheNextMicroStep) {
  SmallRun run(R"({'state': 'R', 'first': 'b', 'variables': [{'name': 'v', 'initial': 0}],
    'actions': [{'when': 'chi.A.res.r == 1', 'do': 'var.v = 1'}], 'children': [
    {'barrier': 'b', 'to': ['A', 'B']},
    {'state': 'A', 'results': [{'name': 'r', 'initial': 0}], 'actions': [{'when': 'svc.t.a', 'do': 'res.r = 1'}]},
    {'state': 'B', 'actions': [{'when': 'svc.t.a', 'do': 'pass'}]}]})");
  run.step();
  EXPECT_THAT(run.event("a"), ElementsAre("SProp R, SProp A, Action1 A#0, SProp B, Action1 B#0",
                                          "SProp R, Action1 R#0, SProp A, Action2 A#0, SProp B, Action2 B#0"));
}

}  // namespace
}  // namespace race::semantics
