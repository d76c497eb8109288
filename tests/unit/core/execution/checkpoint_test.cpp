// Checkpoints of random runs: a run that is written and read goes on as the one that never was.
#include "core/execution/checkpoint.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>

#include "core/execution/replay.h"
#include "core/execution/step_json.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/core/semantics/random_runs.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

std::string text_of(const Execution& execution) { return to_json(checkpoint_json(execution)); }

Expected<Execution> read_text(const JournalHeader& header, const std::string& text) {
  return read_checkpoint(header, parse_json(text, kJournalLimits).value());
}

// Everything that decides how a run goes on, or that is shown of it.
void expect_same(const Execution& a, const Execution& b) {
  const semantics::RunState &x = a.run().state(), &y = b.run().state();
  ASSERT_TRUE(same(x, y));
  ASSERT_EQ(x.epoch, y.epoch);
  ASSERT_EQ(x.occurrence, y.occurrence);
  ASSERT_TRUE(a.is_over() || x.data_units == y.data_units);
  ASSERT_EQ(x.event_tick, y.event_tick);
  ASSERT_EQ(x.response_tick, y.response_tick);
  if (!a.is_over()) {  // a run that is over needs no counts
    ASSERT_EQ(x.arrivals, y.arrivals);
    ASSERT_EQ(x.active_states, y.active_states);
  }
  for (std::size_t s = 0; s < x.live.size(); ++s) {
    ASSERT_EQ(x.live[s].activations, y.live[s].activations);
    ASSERT_EQ(x.live[s].activated_in, y.live[s].activated_in);
    ASSERT_EQ(x.live[s].activated_at, y.live[s].activated_at);
    ASSERT_EQ(x.live[s].calls_before, y.live[s].calls_before);
    ASSERT_EQ(x.live[s].life, y.live[s].life);
    ASSERT_EQ(x.live[s].left_through, y.live[s].left_through);
    ASSERT_EQ(x.live[s].left_during, y.live[s].left_during);
  }
  ASSERT_EQ(a.run().state_json(), b.run().state_json());
  Dict how_a, how_b;
  set_status(a.run(), how_a);
  set_status(b.run(), how_b);
  ASSERT_EQ(Value(how_a), Value(how_b));
  ASSERT_EQ(a.run().position(), b.run().position());
  ASSERT_EQ(a.has_input(), b.has_input());
}

void expect_same(const semantics::Program& program, const Progress& a, const Progress& b) {
  ASSERT_EQ(a.position, b.position);
  ASSERT_EQ(a.micro, b.micro);
  ASSERT_EQ(a.entry, b.entry);
  ASSERT_EQ(a.calls, b.calls);
  ASSERT_EQ(a.printed, b.printed);
  ASSERT_EQ(a.derivation.has_value(), b.derivation.has_value());
  ASSERT_EQ(Value(trace_step(program, a)), Value(trace_step(program, b)));
}

// A random run of a random model, and, from a random position on, the same one from its checkpoint.
class RunWithCheckpoints {
 public:
  explicit RunWithCheckpoints(std::uint64_t seed) : random_(seed), header_(header(random_, seed)) {}

  void run(int steps) {
    for (int step = 0; step < steps && !original_.is_over(); ++step) {
      maybe_restore();
      if (testing::Test::HasFatalFailure()) return;
      for (std::size_t posts = random_.pick(4); posts > 0; --posts) random_.post(runs(), calls());
      do_step();
      if (testing::Test::HasFatalFailure()) return;
    }
    if (!original_.is_over() && random_.chance(0.3))
      for (Execution* each : runs()) each->abort();
    restore();  // how it ended, too
  }

  std::size_t restored = 0, with_waiting = 0, steps_after = 0;

 private:
  static JournalHeader header(semantics::RandomModels& random, std::uint64_t seed) {
    rcm::Document document;
    document.root = random.model().root;
    const semantics::Budgets budgets = semantics::RandomModels::budgets(seed);
    return journal_of(document, semantics::RandomModels::services(), {}, budgets).header;
  }

  std::uint64_t calls() const { return original_.run().state().call_count; }
  std::vector<Execution*> runs() {
    if (!copy_) return {&original_};
    return {&original_, &*copy_};
  }

  void maybe_restore() {
    if (random_.chance(0.15)) restore();
  }

  // From the copy where there is one: a checkpoint of a run that was read is as good.
  void restore() {
    const Execution& from = copy_ && random_.chance(0.5) ? *copy_ : original_;
    const std::string text = text_of(from);
    auto read = read_text(header_, text);
    ASSERT_TRUE(read) << to_string(read.error()) << "\n" << text;
    ASSERT_EQ(text_of(*read), text);
    copy_.emplace(std::move(*read));
    ++restored;
    with_waiting += original_.has_input() ? 1 : 0;
    expect_same(original_, *copy_);
  }

  // With or without trees: without them, only the states of the work set are visited.
  void do_step() {
    const Recording recording{.derivation = random_.chance(0.5)};
    const bool begins = original_.run().position() == 0;
    if (!begins && !original_.has_input() && random_.chance(0.8)) return;
    const auto step = [&](Execution& run) -> const Progress& {
      return begins ? run.start(recording) : run.step(recording);
    };
    const Progress& progress = step(original_);
    if (!copy_) return;
    ++steps_after;
    expect_same(*header_.program, progress, step(*copy_));
    expect_same(original_, *copy_);
  }

  semantics::RandomModels random_;
  JournalHeader header_;
  Execution original_ = Execution::create(header_.program, {}, header_.budgets).value();
  std::optional<Execution> copy_;
};

TEST(Checkpoint, OfARandomRunGoesOnAsTheRunDoes) {
  const std::uint64_t seed = setting("RACE_SEED", 20261122);
  const std::uint64_t journals = setting("RACE_JOURNALS", 150);
  std::cout << "RACE_SEED=" << seed << " RACE_JOURNALS=" << journals << std::endl;
  std::size_t restored = 0, with_waiting = 0, steps_after = 0;
  for (std::uint64_t i = 0; i < journals && !HasFailure(); ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed + i));
    RunWithCheckpoints run(seed + i);
    run.run(40);
    restored += run.restored;
    with_waiting += run.with_waiting;
    steps_after += run.steps_after;
  }
  std::cout << restored << " checkpoints, " << with_waiting << " with waiting inputs, " << steps_after
            << " steps after them" << std::endl;
  EXPECT_GT(with_waiting, journals / 2);
  EXPECT_GT(steps_after, journals);
}

// A journal with checkpoints at some positions, as a store has it.
class StoredJournal final : public JournalSource {
 public:
  explicit StoredJournal(const Journal& journal, std::size_t every) : entries_(journal.entries) {
    const JournalHeader& header = journal.header;
    Execution execution = Execution::create(header.program, header.arguments, header.budgets).value();
    for (const JournalEntry& entry : journal.entries) {
      execution.replay(entry, {}).value();
      if (execution.run().position() % every == 0) checkpoints_[execution.run().position()] = text_of(execution);
    }
  }
  Expected<std::vector<JournalEntry>> entries(std::uint64_t from, std::uint64_t to) override {
    return entries_.entries(from, to);
  }
  Expected<Value> checkpoint(std::uint64_t position) override {
    const auto next = checkpoints_.upper_bound(position);
    if (next == checkpoints_.begin()) return Value::unknown();
    ++read;
    return parse_json(std::prev(next)->second, kJournalLimits);
  }

  std::size_t read = 0;

 private:
  MemoryJournal entries_;
  std::map<std::uint64_t, std::string> checkpoints_;
};

TEST(Checkpoint, GivesTheDerivationsOfTheWholeJournal) {
  const std::uint64_t seed = setting("RACE_SEED", 20261122);
  std::cout << "RACE_SEED=" << seed << std::endl;
  std::size_t used = 0;
  for (std::uint64_t i = 0; i < 30; ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed + i));
    const Journal journal = random_journal(seed + i, 40).first;
    const std::uint64_t last = journal.entries.size();
    const auto source = std::make_shared<StoredJournal>(journal, 3);
    Replay whole(journal.header, std::make_shared<MemoryJournal>(journal.entries));
    const List expected = whole.steps(1, last, last, -1).value();
    for (std::uint64_t from = 1; from <= last; from += 4) {
      const auto steps = Replay(journal.header, source, 1).steps(from, last, last, -1);
      ASSERT_TRUE(steps) << to_string(steps.error());
      ASSERT_EQ(Value(*steps), Value(List(expected.begin() + static_cast<std::ptrdiff_t>(from - 1), expected.end())));
    }
    used += source->read;
  }
  EXPECT_GT(used, 30U) << "checkpoints were read";
}

// One with numbers that JSON could confuse, and an input that waits.
std::pair<JournalHeader, Execution> one_of_numbers() {
  static constexpr const char* kDocument = R"json({"rcm": 1, "name": "numbers", "services": {"t": "timer"}, "root": {
    "state": "Root", "entry": "var.x = [1, 1.0, True, -0.0, 9223372036854775807, 5e-324, None, 'é\\n']",
    "variables": [{"name": "never"}],
    "actions": [{"when": "svc.t.tick", "do": "var.y = svc.t.tick"}],
    "children": [{"state": "Never", "parameters": [{"name": "p", "from": "var.never"}]}]}})json";
  static constexpr const char* kTimer = R"({"operations": [], "events": [{"name": "tick", "sampled": true}]})";
  const JournalHeader header =
      journal_of(rcm::read_document_text(kDocument).value(), {{"t", rsm::read_service_text(kTimer, "timer").value()}})
          .header;
  Execution execution = Execution::create(header.program, {}, header.budgets).value();
  execution.start({});
  execution.post_event("t", "tick", Dict{{"i", std::numeric_limits<std::int64_t>::min()}, {"d", 2.0}, {"n", Value()}});
  execution.step({});
  execution.post_event("t", "tick", 3.0);
  return {header, std::move(execution)};
}

TEST(Checkpoint, KeepsNumbersApartAndWhatHasNoValue) {
  auto [header, execution] = one_of_numbers();
  const std::string text = text_of(execution);
  const Execution read = read_text(header, text).value();
  EXPECT_EQ(text_of(read), text);
  expect_same(execution, read);
  EXPECT_NE(text.find("[1,1.0,true,-0.0,9223372036854775807,5e-324,null,"), std::string::npos) << text;
  EXPECT_EQ(text.find("never"), std::string::npos) << text;
  EXPECT_EQ(read.waiting().size(), 1U);
}

// A has arrived at the barrier; P is left, by its own port, and entered again without A: it is an arrival no more.
TEST(Checkpoint, KeepsTheArrivalsThatGoWithTheirState) {
  static constexpr const char* kDocument = R"json({"rcm": 1, "name": "arrivals", "services": {"t": "timer"}, "root": {
    "state": "Root", "first": "P", "children": [{"state": "P", "first": "S", "children": [
        {"state": "S", "ports": [{"name": "both", "when": "svc.t.both", "to": "fork"}, {"name": "one", "when": "svc.t.one", "to": "B"}]},
        {"barrier": "fork", "to": ["A", "B"]}, {"barrier": "join", "to": ["C"]}, {"state": "C"},
        {"state": "A", "ports": [{"name": "done", "when": "svc.t.a", "to": "join"}]},
        {"state": "B", "ports": [{"name": "done", "when": "svc.t.b", "to": "join"}]}],
      "ports": [{"name": "again", "when": "svc.t.again", "to": "P"}]}]}})json";
  static constexpr const char* kTimer =
      R"({"operations": [], "events": [{"name": "a"}, {"name": "b"}, {"name": "both"}, {"name": "one"}, {"name": "again"}]})";
  const JournalHeader header =
      journal_of(rcm::read_document_text(kDocument).value(), {{"t", rsm::read_service_text(kTimer, "timer").value()}})
          .header;
  Execution execution = Execution::create(header.program, {}, header.budgets).value();
  execution.start({});
  for (const char* event : {"both", "a"}) {
    execution.post_event("t", event, true);
    execution.step({});
  }
  Execution read = read_text(header, text_of(execution)).value();
  for (const char* event : {"again", "one", "b"}) {
    for (Execution* each : {&execution, &read}) {
      each->post_event("t", event, true);
      each->step({});
    }
    expect_same(execution, read);
  }
  EXPECT_EQ(read.run().state_json().find("activated")->as_dict().size(), 1U) << "B has arrived, A has not";
  EXPECT_FALSE(read.run().is_active(header.program->find_state("Root/P/C").value()));
}

TEST(Checkpoint, IsAsLargeAsWhatHasBeenActive) {
  rcm::Document document;
  document.root.name = "Root";
  document.root.first = "S0";
  for (int i = 0; i < 5'000; ++i) {
    rcm::State child;
    child.name = "S" + std::to_string(i);
    rcm::Datum variable;
    variable.name = "v";
    variable.initial = Value(1);
    child.variables.push_back(std::move(variable));
    document.root.children.emplace_back(std::move(child));
  }
  const JournalHeader header = journal_of(document, {}).header;
  Execution execution = Execution::create(header.program, {}, header.budgets).value();
  EXPECT_LT(text_of(execution).size(), 200U);
  execution.start({});
  const Value json = checkpoint_json(execution);
  EXPECT_EQ(json.find("run")->find("states")->as_dict().size(), 2U);
  EXPECT_LT(to_json(json).size(), 500U);
}

TEST(Checkpoint, OfTheExamplesIsReadBackAsItStandsThere) {
  std::ostringstream text;
  text << std::ifstream(RACE_SOURCE_DIR "/api/examples/checkpoint.small.json").rdbuf();
  const Value json = parse_json(text.str(), kJournalLimits).value();
  const auto read = read_checkpoint(small_journal().header, json);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(to_json(checkpoint_json(*read), 1), to_json(json, 1));
}

// `json` with the value at `path`, keys and numbers of items divided by `/`, replaced.
Value with(Value json, std::string_view path, const Value& value) {
  const auto slash = path.find('/');
  const std::string_view key = path.substr(0, slash);
  Value below = value;
  if (slash != std::string_view::npos) {
    const Value inner = json.is_list() ? json.as_list()[std::stoul(std::string(key))] : *json.find(key);
    below = with(inner, path.substr(slash + 1), value);
  }
  if (json.is_list())
    json.mutable_list()[std::stoul(std::string(key))] = below;
  else
    json.mutable_dict().set(key, below);
  return json;
}

Journal small_open_journal() {
  Journal journal = small_journal();
  journal.entries.resize(3);
  return journal;
}

struct Refused {
  const char* path;
  Value value;
  ErrorCode code;
  const char* at;
};

TEST(Checkpoint, IsRefusedWithThePlaceAndTheCode) {
  const Journal journal = small_open_journal();
  const JournalHeader& header = journal.header;
  Execution execution = Execution::create(header.program, header.arguments, header.budgets).value();
  for (const JournalEntry& entry : journal.entries) execution.replay(entry, {}).value();
  execution.post_event("t", "tick", Value(1));
  const Value good = checkpoint_json(execution);
  ASSERT_TRUE(read_checkpoint(header, good)) << to_json(good, 1);
  const Refused all[] = {
      {"checkpoint", 2, ErrorCode::version, "checkpoint"},
      {"more", 1, ErrorCode::unknown_field, "more"},
      {"run", Value(), ErrorCode::type, "run"},
      {"run/position", 0, ErrorCode::out_of_range, "run/epoch"},
      {"run/position", -1, ErrorCode::out_of_range, "run/position"},
      {"run/position", 3.0, ErrorCode::type, "run/position"},
      {"run/tick", 2, ErrorCode::out_of_range, "run/events/0/tick"},
      {"run/call_count", 0, ErrorCode::out_of_range, "run/calls/0/call"},
      {"run/status", "asleep", ErrorCode::type, "run/status"},
      {"run/status", "ended", ErrorCode::conflict, "run/states/Root"},
      {"run/status", "faulted", ErrorCode::conflict, "run/fault"},
      {"run/fault", Dict(), ErrorCode::conflict, "run/fault"},
      {"run/occurrence/event", "unread", ErrorCode::unknown_name, "run/occurrence"},
      {"run/events/0/event", "tock", ErrorCode::unknown_name, "run/events/0"},
      {"run/events/0/data", Value::unknown(), ErrorCode::constant, "run/events/0/data"},
      {"run/calls/0/caller", "Root/Nobody", ErrorCode::unknown_name, "run/calls/0/caller"},
      {"run/calls/0/operation", "fly", ErrorCode::unknown_name, "run/calls/0"},
      {"run/calls/1/result", 1, ErrorCode::conflict, "run/calls/1"},
      {"run/services_called", List{"t", "t"}, ErrorCode::duplicate, "run/services_called"},
      {"run/states/Nobody", Dict(), ErrorCode::unknown_name, "run/states/Nobody"},
      {"run/states/Root/active", false, ErrorCode::conflict, "run/states/Root/A"},
      {"run/states/Root/activations", 0, ErrorCode::conflict, "run/states/Root"},
      {"run/states/Root/activated_in", 99, ErrorCode::out_of_range, "run/states/Root/activated_in"},
      {"run/states/Root/variables", List(), ErrorCode::type, "run/states/Root/variables"},
      {"run/states/Root/variables/won", 1, ErrorCode::unknown_name, "run/states/Root/variables/won"},
      {"run/states/Root/left_through", "over", ErrorCode::conflict, "run/states/Root"},
      {"run/states/Root/left_during", 1, ErrorCode::conflict, "run/states/Root"},
      {"run/states/Root/actions/0/action", 1, ErrorCode::unknown_name, "run/states/Root/actions/0/action"},
      {"run/states/Root/ports", Dict{{"out", Dict()}}, ErrorCode::unknown_name, "run/states/Root/ports/out"},
      {"run/states/Root/ports", Dict{{"over", Dict{{"active", true}}}}, ErrorCode::conflict, "run/states/Root"},
      {"run/states/Root/ports", Dict{{"over", Dict{{"arrived", true}}}}, ErrorCode::conflict, "run/states/Root"},
      {"run/active_barriers", List{"Root/b"}, ErrorCode::unknown_name, "run/active_barriers/0"},
      {"waiting/0/kind", "abort", ErrorCode::unknown_field, "waiting/0/service"},
      {"waiting/0/event", "unread", ErrorCode::conflict, "waiting/0"},
      {"waiting", List{Dict{{"kind", "abort"}}}, ErrorCode::conflict, "waiting/0"},
      {"waiting",
       List{Dict{{"kind", "response"}, {"call", 77}, {"service", "t"}, {"operation", "wait"}, {"result", 1}}},
       ErrorCode::conflict, "waiting/0"},
  };
  for (const Refused& each : all) {
    SCOPED_TRACE(std::string(each.path) + " = " + to_json(each.value));
    const auto read = read_checkpoint(header, with(good, each.path, each.value));
    ASSERT_FALSE(read);
    EXPECT_EQ(std::string(name(read.error().code)), name(each.code)) << to_string(read.error());
    EXPECT_EQ(read.error().path, each.at);
  }
}

TEST(Checkpoint, OfAnotherModelIsRefused) {
  Execution execution = Execution::create(small_journal().header.program, {}, {}).value();
  execution.start({});
  const auto read = read_checkpoint(random_journal(1, 2).first.header, checkpoint_json(execution));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::unknown_name);
}

}  // namespace
}  // namespace race::execution
