// Random conditions in random states: properties that every condition has.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "core/language/evaluate/explain.h"
#include "tests/unit/core/language/environment.h"

namespace race::language::test {
namespace {

constexpr std::uint32_t kConditionSeed = 11;
constexpr int kConditions = 1500;

constexpr const char* kAtoms[] = {"chi.C",
                                  "port.p",
                                  "res.unset",
                                  "res.x > 2",
                                  "res.x == 2.0",
                                  "1 < res.x <= 3",
                                  "res.x in [1, 2]",
                                  "res.x // par.a == 1",
                                  "par.a",
                                  "svc.t.data",
                                  "svc.t.sample",
                                  "svc.t.data.x > 3",
                                  "svc.t.data.y >= 3",
                                  "svc.t.sample.x < 2.5",
                                  "svc.t.data.x in 5",
                                  "svc.t.data.latest == 4",
                                  "svc.t.op.result",
                                  "available(svc.t.data.x)",
                                  "True"};

std::string condition(std::mt19937& random, int depth) {
  const auto part = [&] { return condition(random, depth - 1); };
  switch (depth > 0 ? random() % 4 : 0) {
    case 1:
      return "(" + part() + " and " + part() + ")";
    case 2:
      return "(" + part() + " or " + part() + " or " + part() + ")";
    case 3:
      return "not " + part();
    default:
      return kAtoms[random() % std::size(kAtoms)];
  }
}

void fill(State& state, std::mt19937& random) {
  const auto value = [&] {
    const Value values[] = {Value(0), Value(2), Value(3.5), Value(4), Value("text"), Value::unknown()};
    return values[random() % std::size(values)];
  };
  state.set(State::par_a, value());
  state.set(State::res_x, value());
  state.raise(State::port_p, random() % 2 == 0);
  state.raise(State::child_active, random() % 2 == 0);
  if (random() % 2 == 0) state.answer(0, false, Value(random() % 2 == 0));
  for (EventId event : {0U, 1U})
    if (const Value data = value(); !data.is_unknown())
      state.deliver(event, random() % 4 == 0 ? data : Value(Dict{{random() % 4 == 0 ? "y" : "x", data}}));
  if (random() % 2 == 0) state.occurrence = kNone;
}

// The condition with some of its atoms replaced by what they are to become.
std::string with(std::string text, const Explanation& e, const std::vector<std::size_t>& changed, bool to) {
  for (std::size_t i = e.atoms.size(); i-- > 0;)
    for (const std::size_t c : changed) {
      const SourceRange& at = e.atoms[i].where;
      if (e.atoms[i].text != e.atoms[c].text) continue;
      text.replace(static_cast<std::size_t>(at.column) - 1, static_cast<std::size_t>(at.end_column - at.column),
                   (changed.size() == 1 ? to : e.atoms[c].wanted) ? "True" : "False");
      break;
    }
  return text;
}

// What every condition has in common; `check` gets it compiled, in a state of its own.
template <typename Check>
void for_random_conditions(Check check) {
  std::cout << "seed " << kConditionSeed << "\n";
  std::mt19937 random(kConditionSeed);
  for (int i = 0; i < kConditions; ++i) {
    Runner r;
    fill(r.state, random);
    const std::string text = condition(random, 3);
    const Code code = r.code(text, CodeKind::condition);
    ASSERT_TRUE(code) << text;
    SCOPED_TRACE(text);
    check(r, text, code);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(RandomCondition, HasTheTruthOfItsExplanation) {
  // explain() evaluates without the short cuts that Interpreter::condition takes.
  for_random_conditions([](Runner& r, const std::string&, const Code& code) {
    EXPECT_EQ(r.interpreter.condition(code, r.state), explain(code, r.state).value);
  });
}

TEST(RandomCondition, IsNotTrueWithoutAnOccurrenceIfItNeedsOne) {
  int waiting = 0;
  for_random_conditions([&](Runner& r, const std::string&, const Code& code) {
    if (!code.mentions().needs_occurrence) return;
    ++waiting;
    r.state.occurrence = kNone;
    const Truth truth = r.interpreter.condition(code, r.state);
    EXPECT_TRUE(truth == Truth::no || truth == Truth::unknown);
  });
  EXPECT_GT(waiting, 20);
}

TEST(RandomCondition, HasTheSameTruthWithLessBudgetOrIsAFault) {
  for_random_conditions([](Runner& r, const std::string&, const Code& code) {
    const Truth truth = r.interpreter.condition(code, r.state);
    bool enough = false;
    for (std::uint64_t steps = 1; steps <= 20; ++steps) {
      Interpreter limited(Interpreter::Limits{.steps = steps});
      const Truth got = limited.condition(code, r.state);
      const bool out = got == Truth::fault && limited.fault().kind == FaultKind::budget;
      EXPECT_FALSE(enough && out) << steps;
      enough = !out;
      EXPECT_TRUE(out || got == truth) << steps;
    }
  });
}

TEST(RandomCondition, IsFulfilledByTheChangesThatItsExplanationNames) {
  int explained = 0;
  for_random_conditions([&](Runner& r, const std::string& text, const Code& code) {
    const Explanation e = explain(code, r.state);
    if (e.value == Truth::yes) return;
    explained += e.decisive.empty() ? 0 : 1;
    if (e.together) {
      EXPECT_EQ(r.condition(with(text, e, e.decisive, true)), "True");
      return;
    }
    for (std::size_t i = 0; i < e.atoms.size(); ++i) {
      const bool named = std::find(e.decisive.begin(), e.decisive.end(), i) != e.decisive.end();
      const bool yes = r.condition(with(text, e, {i}, true)) == "True";
      const bool no = r.condition(with(text, e, {i}, false)) == "True";
      EXPECT_EQ(named, !e.atoms[i].reads.empty() && (yes || no)) << e.atoms[i].text;
      EXPECT_TRUE(!named || (e.atoms[i].wanted ? yes : no)) << e.atoms[i].text;
    }
  });
  EXPECT_GT(explained, 200);
}

}  // namespace
}  // namespace race::language::test
