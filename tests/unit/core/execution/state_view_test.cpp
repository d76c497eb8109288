#include "core/execution/state_view.h"

#include <gmock/gmock.h>

#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "core/value/json.h"
#include "tests/unit/core/semantics/driven_run.h"

namespace race::execution {
namespace {

semantics::DrivenRun make_run(const char* text) {
  const auto native = rcm::translate(rcm::read_document_text(text).value()).value();
  return semantics::DrivenRun(semantics::Run::create(semantics::Program::build(native, {}).value(), {}).value());
}

// Two states that meet at a barrier.
constexpr const char* kViewedModel = R"json({"rcm": 1, "root": {"state": "R", "children": [
  {"barrier": "fork", "to": ["A", "B"]},
  {"state": "A", "entry": "var.x = 1", "ports": [{"name": "go", "when": "svc.t.a", "to": "join"}]},
  {"state": "B", "ports": [{"name": "go", "when": "svc.t.b", "to": "join"}]},
  {"barrier": "join", "to": ["C"]},
  {"state": "C", "parameters": [{"name": "p", "value": [1]}]}], "first": "fork"}})json";

// A state that is left for itself, and begins without what it had found.
constexpr const char* kForgetful = R"json({"rcm": 1, "root": {"state": "R", "children": [
  {"state": "A", "results": [{"name": "r"}, {"name": "kept", "initial": 1}],
   "actions": [{"when": "svc.t.a", "do": "var.x = 1\nres.r = 2"}],
   "ports": [{"name": "again", "when": "svc.t.b", "to": "A"}]}], "first": "A"}})json";

struct StateViewTest : testing::Test {
  std::string step(const char* event = nullptr) {
    if (event) run.post_event("t", event, Value());
    run.begin(run.take_input());
    semantics::NoRecorder none;
    while (run.micro(none)) view.note_fired_ports(run);
    return to_json(Value(view.delta(run)));
  }
  semantics::DrivenRun run = make_run(kViewedModel);
  StateView view;
};

TEST_F(StateViewTest, TellsWhatHasChangedAndNothingElse) {
  view.snapshot(run);
  EXPECT_EQ(step(),
            R"({"active":{"R":true,"R/A":true,"R/B":true},"ports":{},"activated":{},"parameters":{},"results":{},)"
            R"("variables":{"R/A":{"x":1}},"unset":{},"fired":[]})");
  EXPECT_EQ(step("a"),
            R"({"active":{"R/A":false},"ports":{},"activated":{"R/join":["R/A.go"]},"parameters":{},"results":{},)"
            R"("variables":{},"unset":{},"fired":["R/A.go"]})");
  EXPECT_EQ(step("b"), R"({"active":{"R/B":false,"R/C":true},"ports":{},"activated":{"R/join":[]},)"
                       R"("parameters":{"R/C":{"p":[1]}},"results":{},"variables":{},"unset":{},"fired":["R/B.go"]})");
}

TEST_F(StateViewTest, TellsWhatHasNoValueAnyMore) {
  run = make_run(kForgetful);
  view.snapshot(run);
  step();
  EXPECT_NE(step("a").find(R"("results":{"R/A":{"r":2}},"variables":{"R/A":{"x":1}},"unset":{},)"), std::string::npos);
  EXPECT_EQ(step("b"), R"({"active":{},"ports":{},"activated":{},"parameters":{},"results":{},"variables":{},)"
                       R"("unset":{"results":{"R/A":["r"]},"variables":{"R/A":["x"]}},"fired":["R/A.again"]})");
}

TEST_F(StateViewTest, ASnapshotContainsWhatHasFired) {
  view.snapshot(run);
  step();
  run.post_event("t", "a", Value());
  run.begin(run.take_input());
  semantics::NoRecorder none;
  while (run.micro(none)) view.note_fired_ports(run);
  view.snapshot(run);
  EXPECT_TRUE(Value(view.delta(run)).find("fired")->as_list().empty());
}

TEST_F(StateViewTest, CountsFromTheLastSnapshot) {
  view.snapshot(run);
  step();
  step("a");
  view.snapshot(run);
  EXPECT_EQ(
      to_json(Value(view.delta(run))),
      R"({"active":{},"ports":{},"activated":{},"parameters":{},"results":{},"variables":{},"unset":{},"fired":[]})");
}

}  // namespace
}  // namespace race::execution
