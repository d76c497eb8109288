// The activation layer: entering and leaving states and barriers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/semantics/small_runs.h"

namespace race::semantics {
namespace {

using testing::ElementsAre;

TEST(SDeact2, LeavesItsChildrenBeforeItsExitFunction) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [
    {'state': 'A', 'results': [{'name': 'child'}, {'name': 'port'}], 'first': 'C',
     'exit': 'res.child = chi.C.active\nres.port = chi.C.port.done', 'ports': [{'name': 'p', 'when': 'svc.t.b'}],
     'children': [{'state': 'C', 'ports': [{'name': 'done', 'when': 'svc.t.a'}]}]}]})");
  run.step();
  run.event("a");
  EXPECT_THAT(run.event("b"), ElementsAre("SProp R, PTrigger A.p, SDeact2 A, SDeact1 C"));
  EXPECT_EQ(run.get("results", "R/A", "child"), Value(false));
  EXPECT_EQ(run.get("results", "R/A", "port"), Value(false)) << "SDeact1 takes the port without destination back";
}

TEST(SDeact2, MakesAnUnmetExitAFaultThatDiscardsTheStep) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [{'state': 'A', 'variables': [{'name': 'v', 'initial': 0}],
    'exit': 'var.v = 1\nvar.v = svc.t.b.x', 'ports': [{'name': 'p', 'when': 'svc.t.a'}]}]})");
  run.step();
  run.event("a");
  ASSERT_TRUE(run->fault());
  EXPECT_EQ(run->fault()->kind, language::FaultKind::unmet);
  EXPECT_EQ(run.active(), "R A");
  EXPECT_EQ(run.get("variables", "R/A", "v"), Value(0));
}

// A is left by a (port p) or b (port q) and entered again by B; its child D counts.
std::string with_keep(const std::string& keep) {
  return R"({'state': 'R', 'first': 'A', 'children': [
    {'state': 'A', )" +
         keep + R"( 'variables': [{'name': 'v', 'initial': 0}], 'entry': 'var.v += 1', 'first': 'D',
     'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'B'}, {'name': 'q', 'when': 'svc.t.b', 'to': 'B'}],
     'children': [{'state': 'D', 'keep': true, 'variables': [{'name': 'v', 'initial': 0}], 'entry': 'var.v += 1',
                   'ports': [{'name': 'again', 'when': 'svc.t.s.x == 1 and svc.t.s', 'to': 'D'}]}]},
    {'state': 'B', 'ports': [{'name': 'back', 'when': 'True', 'to': 'A'}]}]})";
}

TEST(SAct1, ForgetsWhatAnEarlierActivationLeft) {
  SmallRun run(with_keep(""));
  run.step();
  run.event("a");
  EXPECT_EQ(run.get("variables", "R/A", "v"), Value(1));
}

TEST(SAct1, KeepsWhenItsStateWasLastLeftThroughAPortThatKeepNames) {
  SmallRun run(with_keep("'keep': ['p'],"));
  run.step();
  run.event("a");
  EXPECT_EQ(run.get("variables", "R/A", "v"), Value(2));
  run.event("b");
  EXPECT_EQ(run.get("variables", "R/A", "v"), Value(1)) << "q is not named";
}

TEST(SAct1, KeepsWithinOneActivationOfTheParentOnly) {
  SmallRun run(with_keep("'keep': ['p'],"));
  run.step();
  run.event("s", 1);
  EXPECT_EQ(run.get("variables", "R/A/D", "v"), Value(2)) << "D keeps when it is entered again";
  run.event("a");
  EXPECT_EQ(run.get("variables", "R/A/D", "v"), Value(1)) << "D was not left since A was activated";
}

// As with_keep; D is entered with A, and left with it.
std::string with_deep_keep(const std::string& of_a, const std::string& of_d) {
  std::string model = with_keep("'keep': " + of_a + ",");
  const std::string shallow = "'D', 'keep': true";
  return model.replace(model.find(shallow), shallow.size(), "'D', 'keep': " + of_d);
}

TEST(SAct1, KeepsDeepWhatAChildHadThatWasLeftWithItsParent) {
  const std::string deep = "{'deep': true, 'ports': ['p']}", none = "{'deep': true, 'ports': []}";
  SmallRun run(with_deep_keep(deep, none));
  run.step();
  run.event("a");
  run.event("a");
  EXPECT_EQ(run.get("variables", "R/A/D", "v"), Value(3)) << "in one life of A, which three activations belong to";
  run.event("b");
  EXPECT_EQ(run.get("variables", "R/A/D", "v"), Value(1)) << "q is not named, so A's life ends, and that of D";
  for (const auto& [of_a, of_d] : {std::pair(deep, std::string("true")), {"['p']", none}, {deep, "[]"}}) {
    SmallRun forgets(with_deep_keep(of_a, of_d));
    forgets.step();
    forgets.event("a");
    EXPECT_EQ(forgets.get("variables", "R/A/D", "v"), Value(1)) << of_a << " with " << of_d;
  }
}

TEST(SAct1, KeepsInALifeOfTheParentWhatAChildHadThatWasLeftThroughAPort) {
  SmallRun run(with_deep_keep("{'deep': true, 'ports': ['p']}", "['again']"));
  run.step();
  run.event("s", 1);
  EXPECT_EQ(run.get("variables", "R/A/D", "v"), Value(2));
  run.event("a");
  EXPECT_EQ(run.get("variables", "R/A/D", "v"), Value(1))
      << "it was left with A after it had been left through the port";
}

TEST(SAct1, ShowsNothingOfAnEarlierActivationOfDescendants) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [
    {'state': 'A', 'first': 'D', 'ports': [{'name': 'p', 'when': 'svc.t.b', 'to': 'A'}], 'children': [
      {'state': 'D', 'ports': [{'name': 'n', 'when': 'svc.t.a', 'to': 'E'}]},
      {'state': 'E', 'parameters': [{'name': 'q', 'value': 3}], 'results': [{'name': 'r'}], 'entry': 'res.r = 1'}]}]})");
  run.step();
  run.event("a");
  EXPECT_EQ(run.get("parameters", "R/A/E", "q"), Value(3));
  run.event("b");
  EXPECT_EQ(run.active(), "R A D");
  EXPECT_TRUE(run.get("parameters", "R/A/E", "q").is_unknown());
  EXPECT_TRUE(run.get("results", "R/A/E", "r").is_unknown());
}

TEST(SAct1, TellsTheParentThatItsResultsAreInitialAgain) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'variables': [{'name': 'seen', 'initial': 0}],
    'actions': [{'when': 'chi.A.res.r == 0', 'do': 'var.seen += 1'}], 'children': [
    {'state': 'A', 'results': [{'name': 'r', 'initial': 0}], 'actions': [{'when': 'svc.t.b', 'do': 'res.r = 1'}],
     'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'A'}]}]})");
  NoRecorder fast;
  run->macro_step(fast);
  for (const char* event : {"b", "a"}) {
    run->post_event("t", event, {});
    run->macro_step(fast);
  }
  EXPECT_EQ(run.get("variables", "R", "seen"), Value(3));
}

TEST(SAct2, DoesNotResolveTheParametersAgain) {
  SmallRun run(R"({'state': 'R', 'variables': [{'name': 'v', 'initial': 1}], 'first': 'b',
    'actions': [{'when': 'svc.t.a', 'do': 'var.v = 2'}], 'children': [
    {'barrier': 'b', 'to': ['A', 'B']},
    {'state': 'A', 'parameters': [{'name': 'p', 'from': 'var.v'}]},
    {'state': 'B', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'A'}]}]})");
  run.step();
  EXPECT_THAT(run.event("a"),
              ElementsAre("SProp R, Action1 R#0, SProp A, PTrigger B.p, SDeact2 B", "PTrans1 R, Action2 R#0, SAct2 A"));
  EXPECT_EQ(run.get("parameters", "R/A", "p"), Value(1));
}

TEST(BAct1, OpensABarrierThatNoPortLeadsTo) {
  SmallRun run(R"({'state': 'R', 'first': 'b', 'children': [{'barrier': 'b', 'to': ['B', 'A']},
    {'state': 'A'}, {'state': 'B'}]})");
  EXPECT_THAT(run.step(), ElementsAre("SAct1 R, BAct1 b", "PTrans2 R, SAct1 B, SAct1 A, BDeact b"));
}

// A and B join in j; B can go round once more before A arrives.
constexpr const char* kJoin = R"({'state': 'R', 'first': 'fork', 'children': [
    {'barrier': 'fork', 'to': ['A', 'B']}, {'barrier': 'j', 'to': ['A', 'B']},
    {'state': 'A', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'j'}]},
    {'state': 'B', 'ports': [{'name': 'p', 'when': 'svc.t.b', 'to': 'j'}]},
    {'state': 'Again', 'ports': [{'name': 'p', 'when': 'True', 'to': 'B'}]}]})";

TEST(BAct3, WaitsForTheOthersAndSaysWhoHasArrived) {
  SmallRun run(kJoin);
  run.step();
  EXPECT_THAT(run.event("b"), ElementsAre("SProp R, SProp A, PTrigger B.p, SDeact2 B", "PTrans1 R, BAct3 j"));
  const Value state = run->state_json();
  EXPECT_EQ(to_json(*state.find("activated")), R"({"R/j":["R/B.p"]})");
}

TEST(BAct2, OpensWithTheLastArrivalAndTheNextRoundWaitsForAll) {
  SmallRun run(kJoin);
  run.step();
  run.event("b");
  EXPECT_THAT(run.event("a"), ElementsAre("SProp R, PTrigger A.p, SDeact2 A", "PTrans1 R, BAct2 j",
                                          "PTrans2 R, SAct1 A, SAct1 B, BDeact j"));
  EXPECT_THAT(run.event("a"), ElementsAre("SProp R, PTrigger A.p, SDeact2 A, SProp B", "PTrans1 R, BAct3 j"));
}

TEST(BAct3, DoesNotCountAnArrivalOfAnEarlierActivation) {
  SmallRun run(R"({'state': 'R', 'first': 'fork', 'children': [
    {'barrier': 'fork', 'to': ['A', 'B', 'C']}, {'barrier': 'j', 'to': ['C']},
    {'state': 'A', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'j'}]},
    {'state': 'B', 'ports': [{'name': 'p', 'when': 'svc.t.b', 'to': 'j'}]},
    {'state': 'C', 'ports': [{'name': 'again', 'when': 'svc.t.s', 'to': 'B'}]}]})");
  run.step();
  run.event("b");
  run.event("s");  // enters B anew: its arrival is withdrawn
  EXPECT_THAT(run.event("a"), ElementsAre("SProp R, PTrigger A.p, SDeact2 A, SProp B", "PTrans1 R, BAct3 j"));
  const Value state = run->state_json();
  EXPECT_EQ(to_json(*state.find("activated")), R"({"R/j":["R/A.p"]})");
}

}  // namespace
}  // namespace race::semantics
