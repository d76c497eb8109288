// Carrying a run over to an edited program, and forcing values and ports (core/SEMANTICS.md section 9), on small
// models.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/core/semantics/small_runs.h"

namespace race::semantics {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "Root/A" and "Root/A par.x": what the edit to `root` waits for.
std::vector<std::string> waits(SmallRun& run, const std::string& root) {
  std::vector<std::string> out;
  if (const auto edited = run->edited(SmallRun::program(root)); !edited)
    for (const Obstacle& each : edited.error())
      out.push_back(each.path + (each.parameter.empty() ? "" : " par." + each.parameter));
  return out;
}

/// The run goes on with `root`, after the macro step of the edit.
void edit(SmallRun& run, const std::string& root) {
  run->take_calls();  // as the driver of a run does after each macro step
  *run = DrivenRun(run->edited(SmallRun::program(root)).value());
  NoRecorder none;
  run->quiesce(none, Order::declared(), ~0U, [] { return true; });
}

std::string child(const std::string& name, const std::string& id, const std::string& rest = "") {
  return "{'state': '" + name + "'" + (rest.empty() ? "" : ", " + rest) +
         (id.empty() ? "" : ", 'meta': {'id': '" + id + "'}") + "}";
}
std::string root_of(const std::string& children, const std::string& first, const std::string& rest = "") {
  return "{'state': 'R', 'first': '" + first + "', 'children': [" + children + "]" + (rest.empty() ? "" : ", " + rest) +
         "}";
}

TEST(Edit, WaitsForTheOutermostActiveStateThatItDoesNotHave) {
  SmallRun run(
      root_of(child("A", "a", "'first': 'X', 'children': [" + child("X", "x") + "]") + "," + child("B", "b"), "A"));
  run.step();
  EXPECT_THAT(waits(run, root_of(child("B", "b"), "B")), ElementsAre("R/A"));
  EXPECT_THAT(waits(run, root_of(child("A", "a") + "," + child("B", "b"), "B")), ElementsAre("R/A/X"));
  EXPECT_THAT(
      waits(run, root_of(child("A", "a", "'children': [{'barrier': 'X', 'to': [], 'meta': {'id': 'x'}}]"), "A")),
      ElementsAre("R/A/X"))
      << "a barrier is no state";
  EXPECT_THAT(waits(run, "{'state': 'R', 'meta': {'id': 'other'}}"), ElementsAre("R/A"))
      << "the root is the same: one has no id, the names are equal";
  EXPECT_THAT(waits(run, "{'state': 'Q'}"), ElementsAre("R")) << "the root is another one";
}

TEST(Edit, FindsStatesByIdAndWhereOneHasNoneByName) {
  SmallRun run(root_of(child("A", "a"), "A"));
  run.step();
  EXPECT_THAT(waits(run, root_of(child("B", "a"), "B")), IsEmpty());
  EXPECT_THAT(waits(run, root_of(child("A", "b"), "A")), ElementsAre("R/A")) << "both have ids, which differ";
  EXPECT_THAT(waits(run, root_of(child("A", ""), "A")), IsEmpty());
  EXPECT_THAT(waits(run, root_of(child("B", ""), "B")), ElementsAre("R/A"));
  SmallRun nameless(root_of(child("A", ""), "A"));
  nameless.step();
  EXPECT_THAT(waits(nameless, root_of(child("A", "a"), "A")), IsEmpty());
  EXPECT_THAT(waits(nameless, root_of(child("B", "a"), "B")), ElementsAre("R/A"));
}

TEST(Edit, KeepsAValueThatCodeHasUsedBeforeItWasDeclared) {
  const std::string count = "'actions': [{'when': 'svc.t.a', 'do': 'var.n = 3'}]";
  SmallRun run("{'state': 'R', " + count + "}");
  run.step();
  run.event("a");
  edit(run, "{'state': 'R', " + count + ", 'variables': [{'name': 'n', 'initial': 7, 'meta': {'id': 'n'}}]}");
  EXPECT_EQ(run.get("variables", "R", "n"), Value(3));
}

TEST(Edit, WaitsForEveryParameterThatDoesNotResolve) {
  SmallRun run(root_of(child("A", "a"), "A"));
  run.step();
  EXPECT_THAT(
      waits(run, root_of(child("A", "a", R"('parameters': [{'name': 'required'}, {'name': 'faulty', 'from': '1 / 0'},
                  {'name': 'unknown', 'from': 'var.v'}, {'name': 'infinite', 'from': 'math.inf'}, {'name': 'fine', 'from': '1'}])"),
                         "A", "'parameters': [{'name': 'of_root'}]")),
      ElementsAre("R par.of_root", "R/A par.required", "R/A par.faulty", "R/A par.unknown", "R/A par.infinite"));
  EXPECT_THAT(
      waits(run,
            root_of(child("A", "a") + "," + child("B", "b", "'parameters': [{'name': 'p', 'from': '1 / 0'}]"), "A")),
      IsEmpty())
      << "B is not active";
}

// A is left through `done` and entered again; n was counted.
std::string keeping(const std::string& keep, const std::string& port, const std::string& id = "done") {
  return root_of(child("A", "a",
                       "'variables': [{'name': 'n', 'initial': 0}], 'actions': [{'when': 'svc.t.s', 'do': 'var.n = "
                       "5'}], 'ports': [{'name': '" +
                           port + "', 'when': 'svc.t.a', 'to': 'B', 'meta': {'id': '" + id + "'}}]" + keep) +
                     "," + child("B", "b", "'ports': [{'name': 'back', 'when': 'svc.t.b', 'to': 'A'}]"),
                 "A");
}

TEST(Edit, KeepsThePortByWhichAStateWithKeepWasLeft) {
  struct Case {
    std::string edited;
    int n;
  };
  for (const Case& each :
       {Case{keeping(", 'keep': ['finished']", "finished"), 5}, Case{keeping(", 'keep': true", "done"), 5},
        Case{keeping("", "done"), 0}, Case{keeping(", 'keep': true", "done", "another"), 0}}) {
    SmallRun run(keeping(", 'keep': ['done']", "done"));
    run.step();
    run.event("s");
    run.event("a");
    edit(run, each.edited);
    run.event("b");
    EXPECT_EQ(run.active(), "R A");
    EXPECT_EQ(run.get("variables", "R/A", "n"), Value(each.n)) << each.edited;
  }
}

TEST(Edit, OfAStateThatGetsKeepDoesNotKnowByWhichPortItWasLeft) {
  SmallRun run(keeping("", "done"));
  run.step();
  run.event("s");
  run.event("a");
  edit(run, keeping(", 'keep': true", "done"));
  run.event("b");
  EXPECT_EQ(run.get("variables", "R/A", "n"), Value(0));
}

// Only a computed name reaches w.f after the edit; its response has come before, while the action could not run.
TEST(Edit, KnowsThatAResponseWasDeliveredAlsoIfOnlyComputedNamesMeanItNow) {
  const auto root = [](const std::string& naming) {
    return R"({'state': 'R', 'variables': [{'name': 'n', 'initial': 1}], 'entry': 'svc[\'w\' if var.n else \'w\'].f()', 'actions': [)" +
           naming +
           R"({'when': 'svc[\'w\' if var.n else \'w\'].f.result and var.n', 'do': 'svc.t.g()'},
      {'when': 'svc.t.a', 'do': 'svc[\'w\' if var.n else \'w\'].f()\nvar.n = 0'}, {'when': 'svc.t.b', 'do': 'var.n = 1'}]})";
  };
  SmallRun run(root("{'when': 'svc.w.f.error', 'do': 'pass'},"));
  run.step();
  run.result(1, 1);
  run.event("a");
  EXPECT_THAT(run.calls(), ElementsAre("w.f()#1", "t.g()#2", "w.f()#3"));
  run.result(3, 1);
  EXPECT_THAT(run.calls(), IsEmpty());
  edit(run, root(""));
  run.event("b");
  EXPECT_THAT(run.calls(), ElementsAre("t.g()#4"));
}

// Of the two equal actions, the first has run for the response; the second could not, as n was 1 by then.
std::string with_equal_actions(int count) {
  const std::string equal = R"({'when': 'svc.t.f.result and var.n == 0', 'do': 'var.n = 1\nsvc.t.g()'},)";
  std::string root = "{'state': 'R', 'variables': [{'name': 'n', 'initial': 0}], 'entry': 'svc.t.f()', 'actions': [";
  for (int i = 0; i < count; ++i) root += equal;
  return root + "{'when': 'svc.t.b', 'do': 'var.n = 0'}]}";
}

TEST(Edit, KeepsTheKthOfEqualActionsAsTheKth) {
  for (const int kept : {2, 1}) {
    SmallRun run(with_equal_actions(2));
    run.step();
    EXPECT_THAT(run.result(1, 1), testing::Contains(testing::HasSubstr("Action1 R#0")));
    edit(run, with_equal_actions(kept));
    run.calls();
    const auto steps = run.event("b");
    EXPECT_THAT(run.calls().size(), kept - 1);
    EXPECT_THAT(steps, testing::Contains(testing::HasSubstr(kept == 2 ? "Action2 R#0 R19, Action1 R#1" : "R#0 R19")));
  }
}

TEST(Edit, CompletesNoBarrierWithoutPorts) {
  const std::string fork = child("A", "a") + ",{'barrier': 'j', 'to': ['A'], 'meta': {'id': 'j'}}";
  SmallRun run(root_of(child("A", "a"), "A"));
  run.step();
  edit(run, root_of(fork, "A"));
  EXPECT_EQ(run.active(), "R A");
}

// ---- Force.

const std::string kForced = root_of(child("A", "a",
                                          "'parameters': [{'name': 'p', 'value': 1}], 'results': [{'name': 'r'}], "
                                          "'ports': [{'name': 'go', 'when': 'False'}]") +
                                        "," + child("B", "b", "'ports': [{'name': 'go', 'when': 'False'}]"),
                                    "A");

Error refusal(SmallRun& run, Force force) {
  const auto forced = run->forced(force);
  EXPECT_FALSE(forced);
  return forced ? Error{} : forced.error();
}

TEST(Force, IsRefusedWithPathAndCode) {
  using enum Force::Scope;
  SmallRun run(kForced);
  run.step();
  struct Case {
    Force force;
    ErrorCode code;
  };
  const double infinite = std::numeric_limits<double>::infinity();
  for (const Case& each :
       {Case{{par, "R/C", "p", 1}, ErrorCode::not_found}, Case{{par, "R/A", "r", 1}, ErrorCode::not_found},
        Case{{res, "R/A", "p", 1}, ErrorCode::not_found}, Case{{var, "R/A", "p", 1}, ErrorCode::not_found},
        Case{{port, "R/A", "stop"}, ErrorCode::not_found}, Case{{port, "R/B", "go"}, ErrorCode::conflict},
        Case{{par, "R/A", "p", infinite}, ErrorCode::constant},
        Case{{par, "R/A", "p", List{Dict{{"x", infinite}}}}, ErrorCode::constant},
        Case{{par, "R/A", "p", Value::unknown()}, ErrorCode::constant}}) {
    const Error error = refusal(run, each.force);
    EXPECT_EQ(error.code, each.code) << error.message;
    EXPECT_EQ(error.path, each.force.path);
  }
  EXPECT_EQ(run.get("parameters", "R/A", "p"), Value(1));
}

TEST(Force, TakesAValueAsLargeAsOneOfTheRunMayBe) {
  const Value largest(std::string(100, 'x'));
  Budgets budgets;
  budgets.evaluation.value_units = largest.size_units();
  SmallRun run(kForced, {}, budgets);
  run.step();
  EXPECT_TRUE(run->forced({Force::Scope::res, "R/A", "r", largest}));
  EXPECT_EQ(refusal(run, {Force::Scope::res, "R/A", "r", Value(std::string(101, 'x'))}).code, ErrorCode::too_large);
}

TEST(Force, KeepsEverythingElseAlsoWhereIdsAreRepeated) {
  SmallRun run(root_of(child("A", "same", "'variables': [{'name': 'v', 'initial': 0}]") + "," + child("B", "same") +
                           ",{'barrier': 'fork', 'to': ['A', 'B']}",
                       "fork"));
  run.step();
  ASSERT_EQ(run.active(), "R A B");
  *run = DrivenRun(run->forced({Force::Scope::var, "R/A", "v", 1}).value());
  EXPECT_EQ(run.active(), "R A B");
  EXPECT_EQ(run.get("variables", "R/A", "v"), Value(1));
}

TEST(Force, OfAPortCountsAsFiringForThePortsOfTheNextActivation) {
  SmallRun run(root_of(child("A", "a", "'ports': [{'name': 'again', 'when': 'svc.t.f.result', 'to': 'A'}]"), "A",
                       "'entry': 'svc.t.f()'"));
  run.step();
  run.result(1, true);
  run->take_calls();
  *run = DrivenRun(run->forced({Force::Scope::port, "R/A", "again"}).value());
  NameRecorder names;
  run->quiesce(names, Order::declared(), ~0U, [] { return true; });
  EXPECT_EQ(std::ranges::count(names.names, Rule::PTrigger), 1) << "R9: once in a macro step";
}

}  // namespace
}  // namespace race::semantics
