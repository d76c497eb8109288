// The budgets of a macro step and of a run's data (core/SEMANTICS.md section 8, Budget).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/semantics/small_runs.h"

namespace race::semantics {
namespace {

std::string fault_of(const SmallRun& run) {
  const auto& fault = const_cast<SmallRun&>(run)->fault();
  return fault ? fault->at + ": " + std::string(language::name(fault->kind)) + ": " + fault->message : "";
}

// With event a, the root does `code`; n times in one macro step.
std::string repeated(const std::string& code, int n) {
  std::string children = "{'state': 'Idle', 'ports': [{'name': 'go', 'when': 'svc.t.a', 'to': 'S0'}]}";
  for (int i = 0; i < n; ++i) {
    children += ", {'state': 'S" + std::to_string(i) + "', 'entry': '" + code + "'";
    if (i + 1 < n) children += ", 'ports': [{'name': 'p', 'when': 'True', 'to': 'S" + std::to_string(i + 1) + "'}]";
    children += "}";
  }
  return "{'state': 'R', 'variables': [{'name': 'v'}], 'first': 'Idle', 'children': [" + children + "]}";
}

std::string fault_after(const std::string& model, Budgets budgets) {
  SmallRun run(model, {}, budgets);
  run.step();
  run.event("a");
  return fault_of(run);
}

TEST(Budgets, OfAMacroStepAreSharedByItsFunctions) {
  const std::string loop = "for i in range(500):\\n    pass";  // about 1000 units
  Budgets budgets;
  budgets.work = 3020;
  EXPECT_EQ(fault_after(repeated(loop, 3), budgets), "");
  EXPECT_EQ(fault_after(repeated(loop, 4), budgets), "R/S3: budget: more than 3020 steps in one macro step");
}

TEST(Budgets, OfAMacroStepBeginAnewWithTheNext) {
  Budgets budgets;
  budgets.work = 1500;
  SmallRun run("{'state': 'R', 'actions': [{'when': 'svc.t.a', 'do': 'for i in range(500): pass'}]}", {}, budgets);
  run.step();
  for (int i = 0; i < 5; ++i) run.event("a");
  EXPECT_EQ(fault_of(run), "");
}

TEST(Budgets, CountParameters) {
  Budgets budgets;
  budgets.work = 3000;
  const auto child = [](const std::string& from) {
    return "{'state': 'R', 'first': 'A', 'children': [{'state': 'A', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': "
           "'B'}]}, "
           "{'state': 'B', 'parameters': [{'name': 'x', 'from': '" +
           from + "'}]}]}";
  };
  EXPECT_EQ(fault_after(child("len([i for i in range(100)])"), budgets), "");
  EXPECT_EQ(fault_after(child("len([i for i in range(5000)])"), budgets),
            "R/B: budget: more than 3000 steps in one macro step");
}

TEST(Budgets, BoundTheCallsOfAMacroStep) {
  Budgets budgets;
  budgets.calls = 5;
  SmallRun run(repeated("svc.t.f(1)", 5), {}, budgets);
  run.step();
  run.event("a");
  EXPECT_EQ(fault_of(run), "");
  EXPECT_EQ(run.calls().size(), 5U);
  EXPECT_EQ(fault_after(repeated("svc.t.f(1)", 6), budgets), "R/S5: budget: more than 5 calls in one macro step");
  EXPECT_EQ(fault_after(repeated("for i in range(6): svc.t.f(i)", 1), budgets),
            "R/S0: budget: more than 5 calls in one macro step");
}

TEST(Budgets, BoundWhatAMacroStepSendsAndPrints) {
  Budgets budgets;
  budgets.output_units = 1000;
  EXPECT_EQ(fault_after(repeated("svc.t.f([1] * 400)", 2), budgets), "");
  EXPECT_EQ(fault_after(repeated("svc.t.f([1] * 400)", 3), budgets),
            "R/S2: budget: more than 1000 units called with and printed in one macro step");
  EXPECT_EQ(fault_after(repeated("print(str([1] * 100))", 3), budgets), "");
  EXPECT_EQ(fault_after(repeated("print(str([1] * 100))", 4), budgets),
            "R/S3: budget: more than 1000 units called with and printed in one macro step");
}

TEST(Budgets, BoundTheValuesThatARunHolds) {
  Budgets budgets;
  budgets.data_units = 10'000;
  const auto writes = [](const char* code) {
    return "{'state': 'R', 'variables': [{'name': 'v'}, {'name': 'w'}], 'first': 'Idle', 'children': ["
           "{'state': 'Idle', 'ports': [{'name': 'go', 'when': 'svc.t.a', 'to': 'C'}]}, {'state': 'C', 'variables': "
           "[{'name': 'x'}]}], 'actions': [{'when': 'svc.t.a', 'do': '" +
           std::string(code) + "'}]}";
  };
  EXPECT_EQ(fault_after(writes("var.v = [0] * 9999"), budgets), "");
  EXPECT_EQ(fault_after(writes("var.v = [0] * 10000"), budgets),
            "R: budget: the values of the run have more than 10000 units");
  EXPECT_EQ(fault_after(writes("var.v = [0] * 6000\\nvar.w = [0] * 6000"), budgets),
            "R: budget: the values of the run have more than 10000 units");
  EXPECT_EQ(fault_after(writes("var.v = [0] * 6000\\nvar.v = 1\\nvar.w = [0] * 6000"), budgets), "") << "what is held";
}

TEST(Budgets, AreMetByWhatARunHoldsWhateverBecameOfItBefore) {
  Budgets budgets;
  budgets.data_units = 1000;
  SmallRun run(
      "{'state': 'R', 'variables': [{'name': 'v', 'initial': []}], 'actions': [{'when': 'svc.t.a', 'do': "
      "'var.v.append(0)'}, {'when': 'svc.t.b', 'do': 'var.v = []'}]}",
      {}, budgets);
  run.step();
  for (int i = 0; i < 900; ++i) run.event("a");
  EXPECT_EQ(run->state().data_units, 901U);
  run.event("b");
  EXPECT_EQ(run->state().data_units, 1U);
  for (int i = 0; i < 999; ++i) run.event("a");
  EXPECT_EQ(fault_of(run), "");
  run.event("a");
  EXPECT_EQ(fault_of(run), "R: budget: the values of the run have more than 1000 units");
  EXPECT_EQ(run.get("variables", "R", "v").as_list().size(), 999U) << "the micro step is discarded";
}

TEST(Budgets, CountNothingOfAFunctionThatIsUnmet) {
  Budgets budgets;
  budgets.output_units = 100;
  SmallRun run("{'state': 'R', 'actions': [{'when': 'True', 'do': 'print(30 * str(1))\\nvar.x = svc.t.f.result'}]}", {},
               budgets);
  run.step();
  for (int i = 0; i < 10; ++i) run.event("a");
  EXPECT_EQ(fault_of(run), "");
}

}  // namespace
}  // namespace race::semantics
