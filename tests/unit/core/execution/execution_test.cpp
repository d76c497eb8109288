// The driver of a run: what one input comes to, in one part or in many, live, replayed and as a script.
#include "core/execution/execution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

#include "core/execution/replay.h"
#include "core/execution/script.h"
#include "core/execution/step_json.h"
#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "core/value/json.h"
#include "tests/unit/core/semantics/random_models.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

using semantics::Program;
using semantics::RandomModels;
using testing::ElementsAre;

constexpr const char* kModel = R"json({"rcm": 1, "root": {"state": "R", "first": "A", "children": [
  {"state": "A", "entry": "print('in A')\nsvc.t.f(1)", "ports": [{"name": "go", "when": "svc.t.f.result", "to": "B"}]},
  {"state": "B", "entry": "svc.t.f(2)", "ports": [{"name": "go", "when": "svc.t.a", "to": "C"}]},
  {"state": "C"}]}})json";

rsm::Service service() {
  rsm::Service service;
  for (const char* name : {"f", "halt"}) {
    service.operations.emplace_back().name = name;
    service.operations.back().safe = service.operations.back().name == "halt";
  }
  service.events.emplace_back().name = "a";
  return service;
}

Execution make_execution() {
  const auto native = rcm::translate(rcm::read_document_text(kModel).value()).value();
  return Execution::create(Program::build(native, {{"t", service()}}).value(), {}).value();
}

std::vector<std::string> names(const std::vector<semantics::OutgoingCall>& calls) {
  std::vector<std::string> out;
  for (const auto& call : calls) out.push_back(call.name + "#" + std::to_string(call.number));
  return out;
}

TEST(Execution, TurnsAnInputIntoItsEntryItsCallsItsTextsItsChangeAndItsDerivation) {
  Execution execution = make_execution();
  execution.watch();
  const Progress start = execution.start({.derivation = true});
  EXPECT_EQ(start.position, 1U);
  EXPECT_EQ(start.entry, JournalEntry(StartEntry{}));
  EXPECT_THAT(start.printed, ElementsAre("in A"));
  EXPECT_THAT(names(start.calls), ElementsAre("f#1"));
  EXPECT_TRUE(start.complete);
  EXPECT_TRUE(execution.post_response(1, false, 7));
  const Progress progress = execution.step({.derivation = true});
  EXPECT_EQ(progress.position, 2U);
  EXPECT_EQ(progress.entry, JournalEntry(ResponseEntry{1, "t", "f", false, 7}));
  EXPECT_THAT(names(progress.calls), ElementsAre("f#2"));
  EXPECT_EQ(to_json(*progress.delta.find("active")), R"({"R/A":false,"R/B":true})");
  ASSERT_TRUE(progress.derivation);
  EXPECT_EQ(progress.derivation->micro.size(), progress.micro);
}

TEST(Execution, RecordsNothingThatNobodyAsksFor) {
  Execution execution = make_execution();
  const Progress start = execution.start({.entry = false});
  EXPECT_FALSE(start.derivation);
  EXPECT_EQ(start.delta.size(), 0U);
  execution.post_response(1, false, 7);
  EXPECT_FALSE(execution.step({.entry = false}).entry);
}

TEST(Execution, StartsWithoutAnInputSoThatThoseThatWaitHaveMacroStepsOfTheirOwn) {
  Execution execution = make_execution();
  EXPECT_TRUE(execution.post_event("t", "a", {}));
  EXPECT_EQ(execution.start({}).entry, JournalEntry(StartEntry{}));
  EXPECT_EQ(execution.waiting().size(), 1U);
  EXPECT_EQ(execution.step({}).entry, JournalEntry(EventEntry{"t", "a", {}}));
}

TEST(Execution, AnswersOpenCallsToALostServiceAndForgetsWhatWaitsWhenItIsOver) {
  Execution execution = make_execution();
  execution.start({});
  execution.post_lost("t");
  EXPECT_EQ(execution.waiting().size(), 1U);
  const Progress end = execution.abort();
  EXPECT_EQ(end.entry, JournalEntry(AbortEntry{}));
  EXPECT_EQ(end.position, 2U);
  EXPECT_THAT(names(end.calls), ElementsAre("halt#2"));
  EXPECT_EQ(execution.waiting().size(), 0U);
  EXPECT_FALSE(execution.post_event("t", "a", {}));
}

// Both ports of A can fire.
constexpr const char* kRace = R"json({"rcm": 1, "root": {"state": "R", "first": "A", "children": [
  {"state": "A", "ports": [{"name": "p", "when": "True", "to": "B"}, {"name": "q", "when": "True", "to": "C"}]},
  {"state": "B"}, {"state": "C"}]}})json";

TEST(Execution, TakesPortsInTheOrderThatItIsGivenWhateverIsRecorded) {
  const auto program = Program::build(rcm::translate(rcm::read_document_text(kRace).value()).value(), {}).value();
  for (const bool derivation : {false, true}) {
    Execution execution = Execution::create(program, {}).value();
    Execution reversed = execution;
    reversed.set_order(semantics::Order::reversed(*program));
    execution.start({.derivation = derivation});
    reversed.start({.derivation = derivation});
    EXPECT_TRUE(execution.run().is_active(program->find_state("R/B").value()));
    EXPECT_TRUE(reversed.run().is_active(program->find_state("R/C").value()));
  }
}

TEST(Execution, RefusesAnEntryOfAnotherRunAndGoesOnAsBefore) {
  Execution execution = make_execution();
  execution.start({});
  for (const JournalEntry& entry :
       {JournalEntry(ResponseEntry{2, "t", "f", false, {}}), JournalEntry(ResponseEntry{1, "t", "g", false, {}}),
        JournalEntry(ResponseEntry{1, "u", "f", false, {}}), JournalEntry(EventEntry{"t", "b", {}})}) {
    const auto refused = execution.replay(entry, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::conflict);
  }
  EXPECT_TRUE(execution.replay(ResponseEntry{1, "t", "f", false, {}}, {}));
  EXPECT_EQ(execution.run().position(), 2U);
}

// What one macro step came to, as text; a whole one, or the sum of its parts.
struct Step {
  explicit Step(const Program& program, const Progress& progress) { add(program, progress); }
  void add(const Program& program, const Progress& progress) {
    for (const Value& call : calls_json(progress.calls)) calls.push_back(call);
    if (progress.derivation)
      for (const Value& tree : micro_steps_json(program, *progress.derivation)) micro.push_back(tree);
  }
  bool operator==(const Step&) const = default;
  List calls, micro;
};

// A random model and a random run of it, live: its journal and what came of each entry.
struct LiveRun {
  LiveRun(std::uint64_t seed, int limit) : random(seed), native(random.model()) {
    budgets = RandomModels::budgets(seed);
    program = Program::build(native, RandomModels::services()).value();
    Execution execution = Execution::create(program, {}, budgets).value();
    const Recording recording{.derivation = true};
    take(execution, execution.start(recording));
    for (int i = 0; i < limit && !execution.is_over(); ++i) {
      random.post<Execution>({&execution}, execution.run().state().call_count);
      if (execution.has_input()) take(execution, execution.step(recording, part()));
    }
    if (!execution.is_over() && random.chance(0.3)) take(execution, execution.abort());
    state = execution.run().state_json();
    status = execution.run().status();
  }
  std::uint32_t part() {
    return random.chance(0.5) ? Execution::kNoLimit : static_cast<std::uint32_t>(1 + random.pick(3));
  }
  void take(Execution& execution, const Progress& first) {
    entries.push_back(first.entry.value());
    steps.emplace_back(*program, first);
    std::uint32_t micro = first.micro;
    while (execution.is_open()) {
      const Progress more = execution.continue_step(part());
      EXPECT_EQ(more.entry, first.entry);
      EXPECT_EQ(more.position, first.position);
      EXPECT_EQ(more.first, micro);
      micro = more.micro;
      steps.back().add(*program, more);
    }
  }
  Journal journal() const { return {{rcm::write_state(native.root), program, {}, budgets}, entries}; }

  RandomModels random;
  rcm::NativeModel native;
  semantics::Budgets budgets;
  std::shared_ptr<const Program> program;
  std::vector<JournalEntry> entries;
  std::vector<Step> steps;
  Value state;
  semantics::Status status{};
};

// `whole`: parts of a macro step that is open are untold; what is told of all is what is told of parts.
TEST(Execution, TellsPartsOfAMacroStepAsOneIfItIsToBeWhole) {
  Execution whole = make_execution(), parts = make_execution();
  whole.watch();
  parts.watch();
  const Progress first = whole.start({.derivation = true, .whole = true}, 0);
  EXPECT_TRUE(first.untold);
  EXPECT_THAT(first.calls, testing::IsEmpty());
  EXPECT_TRUE(whole.has_untold());
  const Progress all = whole.continue_step(), expected = parts.start({.derivation = true});
  EXPECT_FALSE(all.untold);
  EXPECT_TRUE(all.complete);
  EXPECT_EQ(all.first, 0U);
  EXPECT_EQ(all.micro, expected.micro);
  EXPECT_EQ(all.entry, expected.entry);
  EXPECT_EQ(all.calls, expected.calls);
  EXPECT_EQ(all.printed, expected.printed);
  EXPECT_EQ(all.delta, expected.delta);
  EXPECT_EQ(Step(whole.run().program(), all), Step(parts.run().program(), expected));
}

TEST(Execution, TellsAPartThatSomebodyAsksForAndThenTheRest) {
  const char* const counts =
      R"json({"rcm": 1, "root": {"state": "R", "variables": [{"name": "n", "initial": 0}], "first": "A",
    "children": [{"state": "A", "entry": "svc.t.f(1)", "ports": [{"name": "p", "when": "True", "to": "B"}]},
                 {"state": "B", "entry": "svc.t.f(2)", "ports": [{"name": "p", "when": "True", "to": "C"}]}, {"state": "C"}]}})json";
  const auto native = rcm::translate(rcm::read_document_text(counts).value()).value();
  Execution execution = Execution::create(Program::build(native, {{"t", service()}}).value(), {}).value();
  EXPECT_TRUE(execution.start({.whole = true}, 1).untold);
  const Progress part = execution.tell_part();
  EXPECT_THAT(names(part.calls), ElementsAre("f#1"));
  EXPECT_FALSE(execution.has_untold());
  EXPECT_TRUE(execution.continue_step(1).untold);
  const Progress rest = execution.continue_step();
  EXPECT_EQ(rest.first, 1U);
  EXPECT_THAT(names(rest.calls), ElementsAre("f#2"));
  EXPECT_TRUE(rest.complete);
}

TEST(RandomRuns, AreTheSameLiveInPartsAndReplayed) {
  const std::uint64_t seed = setting("RACE_SEED", 20141122), journals = setting("RACE_JOURNALS", 200);
  std::cout << "RACE_SEED=" << seed << " RACE_JOURNALS=" << journals << std::endl;
  for (std::uint64_t i = 0; i < journals; ++i) {
    LiveRun live(seed + i, 40);
    Execution replayed = Execution::create(live.program, {}, live.budgets).value();
    for (std::size_t k = 0; k < live.entries.size(); ++k) {
      const auto progress = replayed.replay(live.entries[k], {.derivation = true});
      ASSERT_TRUE(progress) << "seed " << seed + i << ", entry " << k << ": " << progress.error().message;
      ASSERT_EQ(Step(*live.program, **progress), live.steps[k]) << "seed " << seed + i << ", entry " << k;
    }
    EXPECT_EQ(replayed.run().state_json(), live.state) << "seed " << seed + i;
    EXPECT_EQ(replayed.run().status(), live.status) << "seed " << seed + i;
  }
}

// `race derive` has the budgets of every run.
TEST(RandomRuns, ExportedAsScriptsHaveTheSameDerivations) {
  const std::uint64_t seed = setting("RACE_SEED", 7), journals = setting("RACE_JOURNALS", 120);
  std::cout << "RACE_SEED=" << seed << " RACE_JOURNALS=" << journals << std::endl;
  std::uint64_t compared = 0;
  for (std::uint64_t i = 0; i < journals; ++i) {
    const LiveRun live(seed + i, 30);
    if (live.status == semantics::Status::faulted) continue;  // perhaps by the small budget of this test
    const auto script = read_script(script_json(live.journal()));
    ASSERT_TRUE(script) << "seed " << seed + i << ": " << to_string(script.error()[0]);
    rcm::Document document;
    document.root = live.native.root;
    const auto derived = derive(document, *script);
    ASSERT_TRUE(derived) << "seed " << seed + i;
    const List& steps = derived->find("steps")->as_list();
    const bool aborted = live.status == semantics::Status::aborted;
    ASSERT_EQ(steps.size(), live.steps.size() - (aborted ? 1 : 0)) << "seed " << seed + i;
    for (std::size_t k = 0; k < steps.size(); ++k)
      ASSERT_EQ(*steps[k].find("micro"), Value(live.steps[k].micro)) << "seed " << seed + i << ", step " << k;
    ++compared;
  }
  EXPECT_GT(compared, journals / 2);
}

}  // namespace
}  // namespace race::execution
