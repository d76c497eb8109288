// Random models that are edited while they run, by several authors: every carried edit leaves a run that section 9 of
// core/SEMANTICS.md describes, and what ran live runs again from its journal and from its checkpoints.
// RACE_SEED and RACE_EDITS (of each model) choose another; both are printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "core/edit/apply.h"
#include "core/edit/history.h"
#include "core/execution/checkpoint.h"
#include "core/execution/script.h"
#include "core/execution/step_json.h"
#include "core/rcm/constraints.h"
#include "core/rcm/ids.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/core/execution/naive_carry_over.h"
#include "tests/unit/core/execution/random_run_edits.h"
#include "tests/unit/core/semantics/random_runs.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

using semantics::PortId;
using semantics::Program;
using semantics::Run;
using semantics::RunState;
using semantics::StateId;
using semantics::StateInfo;
using semantics::Status;

// ---- The invariants of section 9, sentence by sentence; the first that does not hold, or nothing.

std::string broken_of_state(const Program& p, const RunState& r, std::uint32_t number) {
  const StateInfo& s = p.states[number];
  const auto is_active = [&](StateId id) { return id == semantics::kNoState || r.flags[p.flag(id)] != 0; };
  const bool active = r.flags[p.flag(StateId{number})] != 0;
  if (active && !is_active(s.parent)) return s.path + ": active implies parent active";
  for (const PortId port : s.ports) {
    if (!r.flags[p.flag(port)]) continue;
    if (active) return p.address(port) + ": an active port's state is inactive";
    if (!is_active(s.parent)) return p.address(port) + ": the parent of an active port's state is active";
  }
  for (std::size_t i = 0; active && i < s.parameters.size(); ++i)
    if (r.values[s.first_parameter + i].is_unknown())
      return s.path + "." + s.parameters[i].name + ": parameters of active states are set";
  return "";
}

std::string broken(const Run& run) {
  const Program& p = run.program();
  const RunState& r = run.state();
  if (run.status() == Status::running && !r.flags[p.flag(Program::root)]) return "the root is active";
  for (std::uint32_t s = 0; s < p.states.size(); ++s)
    if (std::string found = broken_of_state(p, r, s); !found.empty()) return found;
  for (std::uint32_t port = 0; port < p.ports.size(); ++port) {
    if (!r.arrived[port]) continue;
    const semantics::NodeRef to = p.ports[port].to;
    if (!to || !to.barrier) return p.address(PortId{port}) + ": activated(b) is part of in(b)";
    if (!r.flags[p.flag(p.barriers[to.number].parent)]) return p.barriers[to.number].path + ": activated(b) is empty";
  }
  for (std::uint32_t b = 0; b < p.barriers.size(); ++b)
    if (r.flags[p.flag(semantics::BarrierId{b})] && !r.flags[p.flag(p.barriers[b].parent)])
      return p.barriers[b].path + ": active implies parent active";
  return "";
}

// ---- The same macro step, done in several ways.

std::vector<semantics::Rule> rules_of(const semantics::Derivation& derivation) {
  using semantics::Rule;
  static const std::set<Rule> kParts = {Rule::CondBE, Rule::CondBD, Rule::FuncST, Rule::FuncSD, Rule::FuncSC};
  std::vector<Rule> rules;
  for (const semantics::DerivationNode& node : derivation.nodes)
    if (!kParts.contains(node.rule)) rules.push_back(node.rule);
  std::ranges::sort(rules);
  return rules;
}

Value step_of(const Execution& execution, const Progress& progress) {
  Dict json = derived_step(execution, progress).as_dict();
  json.set("position", static_cast<std::int64_t>(progress.position));
  return json;
}

struct Counts {
  std::size_t edits = 0, refused = 0, carried = 0, waited = 0, tried = 0, forces = 0, steps = 0, runs = 0, opened = 0,
              calls = 0;
};

/// A run of a document that is edited. It is driven three times: with trees, without a recorder, and from time to time
/// from a checkpoint.
class RandomEditedRun {
 public:
  RandomEditedRun(semantics::RandomModels& random, const rcm::Document& document, Counts& counts)
      : random_(random), counts_(counts) {
    semantics::Budgets budgets;
    budgets.micro_steps = 300;
    journal_ = journal_of(document, semantics::RandomModels::services(), {}, budgets);
    live_ = Execution::create(journal_.header).value();
    fast_ = live_;
    each([](Execution& run, Recording recording) { return &run.start(recording); });
    ++counts_.runs;
  }

  bool is_over() const { return live_->is_over(); }
  const Execution& live() const { return *live_; }

  /// An input arrives, or several; the first is delivered.
  void step() {
    for (std::size_t i = 1 + random_.pick(2); i > 0; --i) {
      std::vector<Execution*> runs{&*live_, &*fast_};
      if (copy_) runs.push_back(&*copy_);
      random_.post(runs, live_->run().state().call_count);
    }
    if (!live_->has_input()) return;
    WaitingInputs waiting = live_->waiting();
    Run named = live_->run();
    named.begin(waiting.take(named));
    each([](Execution& run, Recording recording) { return &run.step(recording); });
    expect_names(std::move(named));
  }

  /// A value or port of a random state.
  void force() {
    const Program& program = live_->run().program();
    const StateId s{static_cast<std::uint32_t>(random_.pick(program.states.size()))};
    const StateInfo& state = program[s];
    semantics::Force force{semantics::Force::Scope::var, state.path, "v",
                           Value(static_cast<std::int64_t>(random_.pick(4)))};
    if (state.ports.size() > 0 && state.parent != semantics::kNoState && random_.chance(0.5))
      force = {semantics::Force::Scope::port, state.path, program[PortId{state.ports.low}].name};
    auto named = live_->run().forced(force);
    if (!named) return;
    ++counts_.forces;
    each([&](Execution& run, Recording recording) { return run.force(force, recording).value(); });
    expect_names(std::move(*named));
  }

  /// Whether the edit to `document` was carried; else it waits.
  bool edit(const rcm::Document& document) {
    const rcm::NativeModel translated = rcm::translate(document).value();
    const Value native = rcm::write_native(document, translated);
    const EditEntry entry = edit_between(live_->model(), native, semantics::RandomModels::services()).value();
    const ExecutedModel model = edited(live_->model(), entry).value();
    EXPECT_EQ(model.native, native) << "an edit made of two models gives the second";
    ++counts_.tried;
    const Value before = live_->model().native, checkpoint = live_->run().checkpoint_json();
    const Carrying carrying{checkpoint, *before.find("document")->find("root"), *native.find("document")->find("root")};
    auto named = live_->run().edited(model.program);
    if (!named) return expect_obstacles(carrying, named.error()), false;
    EXPECT_EQ(carry_over_difference(carrying, named->checkpoint_json()), "");
    EXPECT_EQ(lost_paths(carrying), std::set<std::string>());
    EXPECT_EQ(unresolved_parameters(carrying), std::set<std::string>());
    EXPECT_EQ(broken(*named), "");
    for (std::uint32_t b = 0; b < model.program->barriers.size(); ++b)
      counts_.opened += named->state().flags[model.program->flag(semantics::BarrierId{b})] != 0 ? 1 : 0;
    each([&](Execution& run, Recording recording) { return run.edit(entry, model, recording).value(); });
    expect_names(std::move(*named));
    if (!is_over()) restore();
    ++counts_.carried;
    return true;
  }

  /// A run whose model is edited to the same model has had one more macro step, in which nothing has occurred.
  void expect_empty_edit_changes_nothing() const {
    const Run& run = live_->run();
    const Run edited = run.edited(live_->model().program).value();
    const RunState &before = run.state(), &after = edited.state();
    EXPECT_EQ(after.values, before.values);
    EXPECT_EQ(after.flags, before.flags);
    EXPECT_EQ(after.arrived, before.arrived);
    EXPECT_EQ(after.arrivals, before.arrivals);
    EXPECT_EQ(after.active_states, before.active_states);
    EXPECT_EQ(after.calls, before.calls);
    EXPECT_EQ(after.served, before.served);
    EXPECT_EQ(after.tick, before.tick);
    EXPECT_EQ(after.call_count, before.call_count);
    EXPECT_EQ(after.event_data, before.event_data);
    EXPECT_EQ(after.event_tick, before.event_tick);
    EXPECT_EQ(after.response_tick, before.response_tick);
    EXPECT_EQ(after.services_called, before.services_called);
    EXPECT_EQ(after.epoch, before.epoch + 1);
    EXPECT_EQ(after.occurrence, semantics::kNone);
    EXPECT_EQ(edited.position(), run.position() + 1);
    EXPECT_TRUE(std::ranges::none_of(after.executed, [&](auto at) { return at == after.epoch; }));
    EXPECT_TRUE(std::ranges::none_of(after.triggered, [&](auto at) { return at == after.epoch; }));
  }

  /// What ran live is what its journal says, from the beginning and from checkpoints.
  void expect_replay() const {
    const Value text = parse_json(to_json(journal_json(journal_)), kJournalLimits).value();
    const auto read = read_journal(text);
    ASSERT_TRUE(read) << to_string(read.error().front());
    ASSERT_EQ(read->entries, journal_.entries);
    const auto steps = derived_steps(*read);
    ASSERT_TRUE(steps) << to_string(steps.error());
    ASSERT_EQ(steps->size(), steps_.size());
    for (std::size_t i = 0; i < steps->size(); ++i)
      for (const char* key : {"micro", "calls", "state"})
        ASSERT_EQ(*(*steps)[i].find(key), *steps_[i].find(key)) << "step " << i << " " << key;
    // A script has the budgets of every run, so not all faults of this test.
    if (live_->run().status() == Status::faulted || steps_.size() % 3 != 0) return;
    const auto script = read_script(script_json(journal_));
    ASSERT_TRUE(script) << to_string(script.error().front());
    const auto document = rcm::read_document(*journal_.header.native.find("document")).value();
    const auto scripted = derive(document, *script);
    ASSERT_TRUE(scripted) << to_string(scripted.error().front());
    const List& again = scripted->find("steps")->as_list();
    ASSERT_EQ(again.size(), steps_.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
      ASSERT_FALSE(again[i].find("waits"));
      for (const char* key : {"micro", "calls", "state"})
        ASSERT_EQ(*again[i].find(key), *steps_[i].find(key)) << "step " << i << " of the script, " << key;
    }
  }

 private:
  // The next macro step, by every run; they agree.
  template <typename Do>
  void each(Do next) {
    const Progress live = *next(*live_, {.entry = true, .derivation = true});
    ASSERT_TRUE(live.entry);
    journal_.entries.push_back(*live.entry);
    steps_.push_back(step_of(*live_, live));
    rules_ = rules_of(*live.derivation);
    ++counts_.steps;
    counts_.calls += live.calls.size();
    ASSERT_EQ(broken(live_->run()), "");
    expect_same(*next(*fast_, {.entry = true, .derivation = false}), live, *fast_);
    if (!copy_) return;
    const Progress copied = *next(*copy_, {.entry = true, .derivation = true});
    expect_same(copied, live, *copy_);
    ASSERT_EQ(step_of(*copy_, copied), steps_.back());
  }
  void expect_same(const Progress& other, const Progress& live, const Execution& run) {
    ASSERT_EQ(other.entry, live.entry);
    ASSERT_EQ(other.calls, live.calls);
    ASSERT_EQ(other.micro, live.micro);
    ASSERT_EQ(run.run().status(), live_->run().status());
    ASSERT_TRUE(same(run.run().state(), live_->run().state()));
    ASSERT_EQ(run.run().checkpoint_json(), live_->run().checkpoint_json());
    ASSERT_EQ(run.waiting().size(), live_->waiting().size());
  }
  // `run` stands at the beginning of the macro step that was done last.
  void expect_names(Run run) {
    semantics::NameRecorder names;
    run.quiesce(names, semantics::Order::declared(), ~0U, [] { return true; });
    std::ranges::sort(names.names);
    ASSERT_EQ(names.names, rules_);
    ASSERT_TRUE(same(run.state(), live_->run().state()));
  }

  // The checkpoint gives the run that it was made of, and is what that one would write.
  void restore() {
    const std::string text = to_json(checkpoint_json(*live_));
    auto read = read_checkpoint(journal_.header, parse_json(text, kJournalLimits).value());
    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_EQ(to_json(checkpoint_json(*read)), text);
    ASSERT_EQ(read->model().native, live_->model().native);
    if (copy_ && random_.chance(0.5)) return;  // the older one goes on
    copy_.emplace(std::move(*read));
  }

  void expect_obstacles(const Carrying& carrying, const std::vector<semantics::Obstacle>& obstacles) {
    std::set<std::string> lost, unresolved;
    for (const semantics::Obstacle& obstacle : obstacles)
      obstacle.kind == semantics::Obstacle::Kind::active ? lost.insert(obstacle.path)
                                                         : unresolved.insert(obstacle.path + "." + obstacle.parameter);
    EXPECT_EQ(lost, lost_paths(carrying));
    EXPECT_TRUE(lost.empty() || unresolved.empty());
    if (!lost.empty()) return;
    const auto expected = unresolved_parameters(carrying);
    EXPECT_TRUE(std::ranges::includes(unresolved, expected)) << *expected.begin();
  }

  semantics::RandomModels& random_;
  Counts& counts_;
  Journal journal_;
  std::optional<Execution> live_, fast_, copy_;
  std::vector<Value> steps_;
  std::vector<semantics::Rule> rules_;  // of the last macro step, sorted
};

/// One who edits: their replica is some revisions behind the server.
struct Author {
  std::string name;
  edit::Tree replica;
  edit::Revision revision = 0;
  RandomRunEdits edits;
};

// Whether runs of it go on, and do not call without end.
bool is_lively(const rcm::Document& document, semantics::RandomModels& random) {
  const Journal journal = journal_of(document, semantics::RandomModels::services());
  Execution run = Execution::create(journal.header).value();
  run.start({});
  for (int i = 0; i < 20 && !run.is_over(); ++i) {
    random.post<Execution>({&run}, run.run().state().call_count);
    if (run.has_input()) run.step({});
  }
  return !run.is_over() && run.run().state().call_count < 60 && run.run().state().active_states > 1;
}

// Small ones, as every edit is checked against the whole document.
edit::Tree first_document(semantics::RandomModels& random) {
  for (;;) {
    rcm::Document out;
    out.root = random.model().root;
    rcm::give_ids(out);
    edit::Tree tree = edit::Tree::read(out).value();
    if (tree.size() > 25 && tree.size() < 100 && is_lively(out, random)) return tree;
  }
}

/// A random model that several authors edit while it runs, one run after the other.
class EditedRunScenario {
 public:
  explicit EditedRunScenario(std::uint64_t seed, Counts& counts)
      : random_(seed, false),
        history_(first_document(random_), 0, {.edits = 100'000}),
        first_(rcm::format_document(history_.tree().document())),
        counts_(counts) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name = "author" + std::to_string(i);
      authors_.push_back({name, history_.tree(), 0, RandomRunEdits(seed * 31 + i, name + "-")});
    }
  }

  void work(std::uint64_t edits) {
    for (const std::size_t end = counts_.edits + edits; counts_.edits < end && !testing::Test::HasFailure();) {
      RandomEditedRun run(random_, history_.tree().document(), counts_);
      bool waits = change();  // also if the run is over at once
      for (int i = 0, waited_steps = 0; i < 60 && !run.is_over() && !testing::Test::HasFailure(); ++i) {
        if (random_.chance(0.6)) waits = change() || waits;
        if (waits) {
          waits = !run.edit(history_.tree().document());
          counts_.waited += waits ? 1 : 0;
          waited_steps = waits ? waited_steps + 1 : 0;
          if (waited_steps > 8) waits = take_back();
        }
        if (!run.is_over() && random_.chance(0.1)) run.force();
        if (!run.is_over()) run.step();
        if (!run.is_over() && random_.chance(0.2)) run.expect_empty_edit_changes_nothing();
      }
      if (!testing::Test::HasFailure()) run.expect_replay();
      if (run.live().run().position() < 15) take_back();
    }
  }

  void expect_undo_of_everything_gives_the_first_document() {
    for (std::size_t i = history_.log().size(); i > 0; --i) {
      const edit::LogEntry& entry = history_.log()[i - 1];
      if (!entry.in_effect) continue;
      ASSERT_TRUE(history_.undo(entry.accepted.author)) << i;
    }
    EXPECT_EQ(rcm::format_document(history_.tree().document()), first_);
  }

 private:
  // Whether the document is another one, which can run; one that cannot is taken back.
  bool change() {
    Author& author = authors_[random_.pick(authors_.size())];
    if (random_.chance(0.5)) follow(author);
    const auto result = random_.chance(0.1) ? history_.undo(author.name)
                        : random_.chance(0.1)
                            ? history_.redo(author.name)
                            : history_.apply(author.name, author.revision, author.edits.edit(author.replica));
    ++counts_.edits;
    const bool can_run = result && rcm::violations(history_.tree().document()).empty();
    if (!can_run) ++counts_.refused;
    if (result && !can_run) take_back_latest();
    return can_run;
  }
  void take_back_latest() {
    const auto kind = history_.log().back().accepted.kind;
    const std::string author = history_.log().back().accepted.author;
    const auto undone = kind == edit::Accepted::Kind::undo ? history_.redo(author) : history_.undo(author);
    ASSERT_TRUE(undone) << to_string(undone.error().error);
  }
  // Nobody waits for ever: edits are taken back until the document can run. Whether it is another one.
  bool take_back() {
    for (int i = 0; i < 10; ++i) {
      const bool undone = history_.undo(authors_[random_.pick(authors_.size())].name).has_value();
      if (undone && !rcm::violations(history_.tree().document()).empty()) take_back_latest();
    }
    return true;
  }
  void follow(Author& author) {
    for (; author.revision < history_.revision(); ++author.revision)
      ASSERT_TRUE(edit::apply(author.replica, history_.log()[author.revision].accepted.edit));
  }

  semantics::RandomModels random_;
  edit::History history_;
  std::string first_;
  Counts& counts_;
  std::vector<Author> authors_;
};

TEST(EditedRandomRuns, AreWhatSection9SaysAndRunAgainFromJournalsAndCheckpoints) {
  constexpr std::uint64_t kModels = 8;
  const std::uint64_t seed = setting("RACE_SEED", 20261122), edits = setting("RACE_EDITS", 50);
  std::cout << "RACE_SEED=" << seed << " RACE_EDITS=" << edits << std::endl;
  Counts counts;
  for (std::uint64_t i = 0; i < kModels && !HasFailure(); ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed + i));
    EditedRunScenario scenario(seed + i, counts);
    scenario.work(edits);
    if (!HasFailure()) scenario.expect_undo_of_everything_gives_the_first_document();
  }
  std::cout << counts.edits << " edits, " << counts.refused << " of documents that cannot run; " << counts.tried
            << " tried, " << counts.carried << " carried, " << counts.waited << " waits; " << counts.forces
            << " forces, " << counts.steps << " macro steps of " << counts.runs << " runs, " << counts.opened
            << " barriers opened, " << counts.calls << " calls" << std::endl;
  EXPECT_GT(counts.carried, counts.edits / 4);
  if (counts.edits < 300) return;
  EXPECT_GT(counts.waited, 0U);
  EXPECT_GT(counts.forces, 0U);
  EXPECT_GT(counts.opened, 0U);
}

}  // namespace
}  // namespace race::execution
