// Why a port fires, an action is executed and a parameter has its value: as things stand, and at its turn within a
// micro step.
#include "core/execution/why.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <memory>

#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "core/value/json.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

using semantics::Program;

/// A run of `{"rcm": 1, "root": root}` with the service `t`: events a and b, operation f; quotes may be written '.
class Asked {
 public:
  explicit Asked(std::string root, const Dict& arguments = {}) : execution_(create(std::move(root), arguments)) {}

  Execution& operator*() { return execution_; }
  Execution* operator->() { return &execution_; }
  void event(std::string_view name) {
    ASSERT_TRUE(execution_.post_event("t", name, Dict()));
    execution_.step({});
  }
  Value port(const std::string& port) { return ask({port, {}, {}, {}}); }
  Value action(const std::string& state, std::uint32_t action) { return ask({{}, state, action, {}}); }
  Value parameter(const std::string& state, const std::string& parameter) { return ask({{}, state, {}, parameter}); }

 private:
  static Execution create(std::string root, const Dict& arguments) {
    for (char& c : root) c = c == '\'' ? '"' : c;
    const auto native = rcm::translate(rcm::read_document_text(R"({"rcm": 1, "root": )" + root + "}").value()).value();
    rsm::Service service;
    for (const char* name : {"a", "b"}) service.events.emplace_back().name = name;
    service.operations.emplace_back().name = "f";
    return Execution::create(Program::build(native, {{"t", service}}).value(), arguments).value();
  }
  Value ask(const WhyQuestion& question) {
    return why_json(execution_, find_subject(execution_.run().program(), question).value());
  }

  Execution execution_;
};

std::string reason(const Value& why) { return why.find("reason")->as_string(); }
std::string text(const Value& why, std::string_view field) {
  const Value* value = why.find(field);
  return value ? to_json(*value) : "";
}

TEST(WhyOfAnAction, NamesTheAtomsThatHoldItBack) {
  Asked run(
      "{'state': 'R', 'variables': [{'name': 'n', 'initial': 0}], 'actions': [{'when': 'var.n > 2', 'do': 'var.n = "
      "0'}]}");
  run->start({});
  const Value why = run.action("R", 0);
  EXPECT_EQ(text(why, "value"), "false");
  EXPECT_EQ(text(why, "executed"), "false");
  EXPECT_EQ(reason(why), "It is executed when `var.n > 2` becomes true.");
  EXPECT_EQ(to_json(*why.find("atoms")->as_list()[0].find("reads")), R"([{"text":"var.n","value":0}])");
}

TEST(WhyOfAnAction, SaysThatItHasBeenExecutedAndWhatItIsExecutedAgainFor) {
  Asked run(
      "{'state': 'R', 'variables': [{'name': 'n', 'initial': 0}], 'actions': [{'when': 'svc.t.a', 'do': 'var.n = var.n "
      "+ 1'}]}");
  run->start({});
  EXPECT_EQ(reason(run.action("R", 0)), "It is executed when `svc.t.a` becomes true.");
  run.event("a");
  EXPECT_EQ(text(run.action("R", 0), "executed"), "true");
  EXPECT_EQ(reason(run.action("R", 0)),
            "It has been executed in this macro step, and is not executed twice in one (3.17).");
}

TEST(WhyOfAnAction, NamesTheDatumThatAServedOneWaitsFor) {
  Asked run(R"({'state': 'R', 'variables': [{'name': 'n', 'initial': 0}],
    'actions': [{'when': 'True', 'do': 'svc.t.f()'}, {'when': 'svc.t.f.result', 'do': 'var.n = var.n + 1'},
                {'when': 'svc.t.b', 'do': 'pass'}]})");
  run->start({});
  ASSERT_TRUE(run->post_response(1, false, 7));
  run->step({});
  run.event("b");
  EXPECT_EQ(text(run.action("R", 0), "held"), R"("R19")");
  EXPECT_EQ(reason(run.action("R", 0)),
            "It has been executed for what it has got, and is executed again when its condition has not been fulfilled "
            "in between (R19).");
  EXPECT_EQ(reason(run.action("R", 1)),
            "It has been executed for what it has got, and is executed again when `svc.t.f` is delivered anew (R19).");
}

TEST(WhyOfAnAction, NamesWhatItsFunctionLacks) {
  Asked run(
      "{'state': 'R', 'variables': [{'name': 'n', 'initial': 0}], 'actions': [{'when': 'True', 'do': 'var.n = "
      "svc.t.a.x'}]}");
  run->start({});
  const Value before = run->run().state_json();
  const Value why = run.action("R", 0);
  EXPECT_EQ(text(why, "value"), "true");
  EXPECT_EQ(text(why, "held"), R"("R3")");
  EXPECT_EQ(reason(why), "Its condition is true, but nothing of its function takes effect: svc.t.a has no value (R3).");
  EXPECT_EQ(run->run().state_json(), before) << "a question changes nothing";
}

// The action of R changes what the port of A and the parameter of B read, in the same micro step.
constexpr const char* kTurns =
    R"({'state': 'R', 'variables': [{'name': 'n', 'initial': 0}, {'name': 'm', 'initial': 0}], 'first': 'A',
  'actions': [{'when': 'svc.t.a', 'do': 'var.n = 1'}, {'when': 'var.n == 1 and var.m == 0', 'do': 'var.m = 5'}],
  'children': [{'state': 'A', 'parameters': [{'name': 'n', 'value': 3}], 'ports': [{'name': 'go', 'when': 'svc.t.a', 'to': 'B'}]},
    {'state': 'B', 'parameters': [{'name': 'given', 'from': 'var.n + var.m'}]}]})";

TEST(WhyAtItsTurn, SeesWhatTheMicroStepHasDoneBefore) {
  Asked run(kTurns);
  run->start({});
  ASSERT_TRUE(run->post_event("t", "a", Dict()));
  run->step({}, 0);
  ASSERT_TRUE(run->is_open());
  const Value first = run.action("R", 0), second = run.action("R", 1);
  EXPECT_EQ(reason(first), "Its condition is true: it is executed in the next micro step.");
  EXPECT_EQ(text(second, "turn"), "true");
  EXPECT_EQ(text(second, "value"), "true") << "the first action has been executed when its turn comes";
  EXPECT_EQ(to_json(*second.find("atoms")->as_list()[0].find("reads")), R"([{"text":"var.n","value":1}])");
  EXPECT_EQ(text(run.port("R/A.go"), "value"), "true");
  EXPECT_EQ(text(run.parameter("R/B", "given"), "turn"), "") << "its turn does not come in this micro step";
  run->continue_step(1);
  const Value given = run.parameter("R/B", "given");
  EXPECT_EQ(text(given, "turn"), "true");
  EXPECT_EQ(text(given, "gives"), "6");
  EXPECT_EQ(text(given, "value"), "") << "it has none before";
  EXPECT_EQ(to_json(*given.find("reads")), R"([{"text":"var.n","value":1},{"text":"var.m","value":5}])");
  run->continue_step();
  EXPECT_EQ(text(run.parameter("R/B", "given"), "value"), "6");
}

TEST(WhyOfAParameter, SaysWhatGivesItAndWhatItWouldBe) {
  Asked run(kTurns);
  run->start({});
  EXPECT_EQ(reason(run.parameter("R/A", "n")), "The model gives it, as a constant.");
  const Value given = run.parameter("R/B", "given");
  EXPECT_EQ(text(given, "gives"), "0");
  EXPECT_EQ(text(given, "expression"), R"("var.n + var.m")");
  EXPECT_EQ(reason(given), "Its expression is resolved when its state is activated.");
  run.event("a");
  EXPECT_EQ(
      reason(run.parameter("R/B", "given")),
      "Its expression was resolved when its state was activated, and is resolved again at the next activation (R10).");
}

TEST(WhyOfAParameter, SaysThatAnActivationWouldBeAFault) {
  Asked run(
      R"({'state': 'R', 'variables': [{'name': 'n'}, {'name': 's', 'initial': 'text'}], 'first': 'A', 'children': [
    {'state': 'A'}, {'state': 'B', 'parameters': [{'name': 'p', 'from': 'var.n'}, {'name': 'q', 'from': 'var.s - 1'}]}]})");
  run->start({});
  EXPECT_EQ(reason(run.parameter("R/B", "p")),
            "As things are, its expression has no value: to activate its state would be a fault (R4).");
  EXPECT_THAT(reason(run.parameter("R/B", "q")),
              testing::StartsWith("As things are, its expression cannot be evaluated: "));
}

TEST(WhyOfAParameter, KnowsTheArgumentsOfTheRun) {
  Asked run("{'state': 'R', 'parameters': [{'name': 'n', 'value': 3}, {'name': 'm', 'value': 4}]}", Dict{{"n", 9}});
  run->start({});
  EXPECT_EQ(reason(run.parameter("R", "n")), "An argument of the run gives it.");
  EXPECT_EQ(text(run.parameter("R", "n"), "gives"), "9");
  EXPECT_EQ(reason(run.parameter("R", "m")), "The model gives it, as a constant.");
}

TEST(WhyOfAPort, KnowsThatSomebodyHasForcedIt) {
  Asked run(
      "{'state': 'R', 'first': 'A', 'children': [{'state': 'A', 'ports': [{'name': 'go', 'when': 'svc.t.a', 'to': "
      "'B'}]}, {'state': 'B'}]}");
  run->start({});
  ASSERT_TRUE(run->force({semantics::Force::Scope::port, "R/A", "go"}, {}, 0));
  const Value why = run.port("R/A.go");
  EXPECT_EQ(text(why, "forced"), "true");
  EXPECT_EQ(text(why, "value"), "null");
}

/// Of every rule that a derivation shows, the explanation at its turn says the same.
void expect_agreement(Execution& before, const Value& node, int& checked) {
  const auto field = [&](std::string_view name) { return node.find(name)->as_string(); };
  const std::string rule = field("rule");
  const auto ask = [&](const WhyQuestion& question) {
    ++checked;
    return why_json(before, find_subject(before.run().program(), question).value());
  };
  if (rule == "PTrigger") {
    const Value why = ask({field("at") + "." + field("port"), {}, {}, {}});
    EXPECT_EQ(text(why, "turn") + text(why, "value"), "truetrue") << to_json(why);
  }
  if (rule == "Action1") {
    const Value why = ask({{}, field("at"), static_cast<std::uint32_t>(node.find("action")->as_integer()), {}});
    EXPECT_EQ(text(why, "turn") + text(why, "value") + text(why, "executed"), "truetruefalse") << to_json(why);
    EXPECT_EQ(text(why, "held"), "");
  }
  if (rule == "Resolve") {
    const Value why = ask({{}, field("at"), {}, field("parameter")});
    EXPECT_EQ(text(why, "turn"), "true") << to_json(why);
    EXPECT_EQ(text(why, "gives"), text(node, "value"));
  }
  for (const Value& premise : node.find("premises")->as_list()) expect_agreement(before, premise, checked);
}

TEST(WhyAtItsTurn, AgreesWithTheDerivationsOfRandomRuns) {
  const std::uint64_t seed = setting("RACE_SEED", 41), journals = sample(12);
  std::cout << "seed " << seed << "\n";
  int checked = 0;
  for (std::uint64_t i = 0; i < journals; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const Journal journal = random_journal(seed + i, 25).first;
    Replay replay(journal.header, std::make_shared<MemoryJournal>(journal.entries));
    for (std::uint64_t step = 1; step <= journal.entries.size(); ++step) {
      const List done = replay.steps(step, step, journal.entries.size(), -1).value();
      const List& micro = done.at(0).find("micro")->as_list();
      for (std::size_t m = 0; m < micro.size(); ++m) {
        Execution before = replay.before(step, static_cast<int>(m)).value();
        expect_agreement(before, micro[m], checked);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
  EXPECT_GT(checked, static_cast<int>(5 * journals)) << "the models hardly do anything";
}

TEST(WhyQuestion, NamesWhatThereIsNot) {
  Asked run(kTurns);
  const Program& program = run->run().program();
  const auto field = [&](const WhyQuestion& question) { return find_subject(program, question).error().path; };
  EXPECT_EQ(field({"R/A.no", {}, {}, {}}), "port");
  EXPECT_EQ(field({{}, "R/No", 0, {}}), "state");
  EXPECT_EQ(field({{}, "R", 2, {}}), "action");
  EXPECT_EQ(field({{}, "R/B", {}, "n"}), "parameter");
}

}  // namespace
}  // namespace race::execution
