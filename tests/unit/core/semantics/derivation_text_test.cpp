// The text form of a derivation document, line by line.
#include "core/semantics/derivation_text.h"

#include <gtest/gtest.h>

#include "core/execution/derive.h"
#include "core/value/json.h"

namespace race::semantics {
namespace {

std::string text_of(const std::string& json) { return derivation_text(parse_json(json).value()); }

std::string node_text(const std::string& fields) {
  const std::string text = text_of(R"({"steps": [{"micro": [{)" + fields + R"(, "premises": []}]}]})");
  const std::string before = "step 1\n  micro 1\n    ";
  EXPECT_EQ(text.substr(0, before.size()), before);
  return text.substr(before.size());
}

TEST(DerivationText, IsOneNodeALine) {
  const auto document = execution::derive_texts(
      R"({"rcm": 1, "root": {"state": "R", "parameters": [{"name": "n", "value": 2}], "results": [{"name": "r"}],
          "entry": "res.r = par.n", "ports": [{"name": "done", "when": "res.r == 2"}]}})",
      R"({"steps": [{}]})");
  ASSERT_TRUE(document);
  EXPECT_EQ(derivation_text(*document), R"(step 1
  micro 1
    Micro 3.31 at R (R13)
      Resolve 3.13 at R, parameter n = 2
      SAct1 3.22 at R
        Active 3.8 at R = false
        Act 3.9 at R
        Func 4.16 at R, of entry
          FuncST 4.15 at R
  micro 2
    Micro 3.31 at R
      PTrigger 3.27 at R, port done
        Active 3.8 at R = true
        Cond 4.12 at R, port done = true
          CondBE 4.11 at R = true
        SDeact2 3.20 at R
          Active 3.8 at R = true
          Deact 3.10 at R
        Act 3.9 at R, port done
  active (none)
  ports R.done
  set R par.n = 2
  set R res.r = 2
ended: done
)");
}

TEST(DerivationText, IsTheSameInParts) {
  const auto step = [](int value) {
    return R"({"micro": [], "state": {"active": ["R"], "results": {"R": {"n": )" + std::to_string(value) +
           R"(, "same": 1}}}})";
  };
  const std::string end = R"("status": "ended", "outcome": "done")";
  const std::string whole = text_of(R"({"steps": [)" + step(1) + ", " + step(2) + ", " + step(3) + "], " + end + "}");
  DerivationText text;
  std::string parts = text.steps(parse_json(R"({"steps": [)" + step(1) + ", " + step(2) + "]}").value());
  parts += text.steps(parse_json(R"({"status": "running", "steps": [)" + step(3) + "]}").value());
  EXPECT_EQ(parts + DerivationText::status(parse_json("{" + end + "}").value()), whole);
  EXPECT_NE(whole.find("step 3\n  active R\n  set R res.n = 3\nended: done\n"), std::string::npos) << whole;
  EXPECT_EQ(DerivationText(7).steps(parse_json(R"({"steps": [{}]})").value()), "step 7\n");
}

TEST(DerivationText, ShowsEveryFieldOfANode) {
  EXPECT_EQ(node_text(R"("rule": "Cond", "equation": "4.9", "at": "R/A", "port": "done", "value": null,
                          "requires": ["t.wait.result", "t.tick"], "refinement": "R2")"),
            "Cond 4.9 at R/A, port done = null requires t.wait.result, t.tick (R2)\n");
  EXPECT_EQ(node_text(R"("rule": "Action3", "equation": "4.3", "at": "R", "action": 0)"),
            "Action3 4.3 at R, action 0\n");
  EXPECT_EQ(node_text(R"("rule": "Func", "equation": "4.16", "at": "R", "of": "action", "action": 1)"),
            "Func 4.16 at R, of action 1\n");
  EXPECT_EQ(node_text(R"("rule": "FuncSC", "equation": "4.14", "at": "R", "service": "t", "operation": "wait",
                          "args": [0.5, "a b"], "kwargs": {"on": [1, true]})"),
            "FuncSC 4.14 at R, call t.wait(0.5, \"a b\", on=[1,true])\n");
}

TEST(DerivationText, KeepsAnyTextOnItsLine) {
  EXPECT_EQ(node_text(R"("rule": "FuncSC", "at": "R", "service": "a\nb", "operation": "", "args": [], "kwargs": {})"),
            "FuncSC at R, call \"a\\nb\".\"\"()\n");
  EXPECT_EQ(text_of(R"({"status": "faulted", "fault": {"kind": "type", "at": "R", "message": "no\nline"}})"),
            "faulted: type at R: \"no\\nline\"\n");
}

TEST(DerivationText, ShowsWhatChangedFromStepToStep) {
  EXPECT_EQ(text_of(R"({"steps": [
      {"micro": [], "calls": [{"service": "t", "operation": "go", "args": [], "kwargs": {}}],
       "state": {"active": ["R", "R/A"], "ports": ["R/A.p"], "activated": {"R/b": ["R/A.p"]},
                 "parameters": {"R/A": {"x": 1}}, "results": {}, "variables": {"R": {"v": 1, "w": 1}}}},
      {"micro": [], "calls": [],
       "waits": [{"path": "R/A", "id": "a"}, {"path": "R", "id": "r", "parameter": "p"}],
       "state": {"active": ["R"], "ports": [], "activated": {},
                 "parameters": {}, "results": {"R": {"y": [1]}}, "variables": {"R": {"v": 1, "w": 1.0}}}}],
      "status": "running"})"),
            R"(step 1
  call t.go()
  active R R/A
  ports R/A.p
  activated R/b by R/A.p
  set R/A par.x = 1
  set R var.v = 1
  set R var.w = 1
step 2
  the edit waits for R/A
  the edit waits for R par.p
  active R
  unset R/A par.x
  set R res.y = [1]
  set R var.w = 1.0
running
)");
}

}  // namespace
}  // namespace race::semantics
