// Executions that are edited and forced: what is carried over besides the run, and their journals, checkpoints, replays
// and scripts. edited_random_test.cpp holds the same on random models.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/edit/apply.h"
#include "core/execution/checkpoint.h"
#include "core/execution/replay.h"
#include "core/execution/script.h"
#include "core/execution/step_json.h"
#include "tests/unit/core/edit/random_edits.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

using semantics::Force;
using testing::IsEmpty;

// A and B follow one another on every event; both count ticks. The id of an element is its name in small letters.
constexpr const char* kEditedModel = R"json({"rcm": 1, "root": {"state": "R", "first": "A", "meta": {"id": "r"},
  "variables": [{"name": "n", "initial": 0, "meta": {"id": "n"}}],
  "actions": [{"when": "svc.t.tick", "do": "var.n = var.n + 1", "meta": {"id": "count"}}],
  "children": [
    {"state": "A", "entry": "svc.t.f()", "meta": {"id": "a"},
     "ports": [{"name": "go", "when": "svc.t.go", "to": "B", "meta": {"id": "ago"}}]},
    {"state": "B", "meta": {"id": "b"}, "ports": [{"name": "go", "when": "svc.t.go", "to": "A", "meta": {"id": "bgo"}}]}],
  "ports": [{"name": "over", "when": "svc.t.f.error", "meta": {"id": "over"}}]}})json";
constexpr const char* kTimer = R"({"operations": [{"name": "f"}, {"name": "stop", "safe": true}],
  "events": [{"name": "go"}, {"name": "tick"}]})";
constexpr const char* kRobot = R"({"operations": [{"name": "move"}, {"name": "halt", "safe": true}],
  "events": [{"name": "force", "sampled": true}]})";

rsm::Service service(const char* text) { return rsm::read_service_text(text, "service").value(); }

struct EditedRun : testing::Test {
  EditedRun() {
    journal.header = journal_of(document, services).header;
    execution = Execution::create(journal.header).value();
    take(execution->start(kRecorded));
  }

  /// The document after the operations, JSON with ' for ".
  void change(std::string operations) {
    std::ranges::replace(operations, '\'', '"');
    const auto edit = edit::read_edit(Dict{{"operations", parse_json(operations).value()}}).value();
    document = edit::apply(document, edit).value().document;
  }
  EditEntry entry() const {
    const rcm::NativeModel native = rcm::translate(document).value();
    EditEntry entry = edit_between(execution->model(), rcm::write_native(document, native), services).value();
    entry.revision = 7;
    return entry;
  }
  /// What the edit waits for; empty if it was carried.
  std::vector<semantics::Obstacle> edit() {
    const EditEntry entry = this->entry();
    auto progress = execution->edit(entry, edited(execution->model(), entry).value(), kRecorded);
    if (!progress) return progress.error();
    take(**progress);
    return {};
  }
  void force(const Force& force) { take(*execution->force(force, kRecorded).value()); }
  Progress event(const char* name) {
    execution->post_event(name == std::string("force") ? "robot" : "t", name, Dict{{"x", 2}});
    return take(execution->step(kRecorded));
  }
  Progress take(const Progress& progress) {
    journal.entries.push_back(progress.entry.value());
    steps.push_back(derived_step(*execution, progress));
    return last = progress;
  }
  std::string active() const { return to_json(*execution->run().state_json().find("active")); }
  Goal goal(Goal::Kind kind, const char* path) const {
    return find_goal(execution->run().program(), {kind, {}, path}).value();
  }
  /// A run with an edit, a force, and a service that comes with the edit.
  void run() {
    event("tick");
    services.emplace("robot", service(kRobot));
    change(
        R"([{'op': 'set', 'id': 'a', 'field': 'state', 'value': 'Arm'}, {'op': 'set', 'id': 'r', 'field': 'first', 'value': 'Arm'},
      {'op': 'set', 'id': 'bgo', 'field': 'to', 'value': 'Arm'},
      {'op': 'insert', 'parent': 'r', 'list': 'actions', 'after': 'count',
       'node': {'when': 'svc.robot.force.x > 1', 'do': 'svc.robot.move(var.n)', 'meta': {'id': 'push'}}}])");
    EXPECT_THAT(edit(), IsEmpty());
    event("force");
    event("tick");
    force({Force::Scope::var, "R", "n", 10});
    force({Force::Scope::port, "R/Arm", "go"});
    event("go");
  }

  static constexpr Recording kRecorded{.entry = true, .derivation = true};
  rcm::Document document = rcm::read_document_text(kEditedModel).value();
  Interfaces services{{"t", service(kTimer)}};
  Journal journal;
  std::optional<Execution> execution;
  std::vector<Value> steps;
  Progress last;
};

constexpr const char* kWithoutA = R"([{'op': 'set', 'id': 'r', 'field': 'first', 'value': 'B'},
  {'op': 'set', 'id': 'bgo', 'field': 'to'}, {'op': 'remove', 'id': 'a'}])";
constexpr const char* kNewNames = R"([{'op': 'set', 'id': 'b', 'field': 'state', 'value': 'C'},
  {'op': 'set', 'id': 'ago', 'field': 'to', 'value': 'C'}, {'op': 'move', 'id': 'b', 'parent': 'r', 'list': 'children'}])";

TEST_F(EditedRun, IsAsItWasWhileAnEditWaits) {
  change(kWithoutA);
  const Value before = checkpoint_json(*execution);
  const auto obstacles = edit();
  ASSERT_EQ(obstacles.size(), 1U);
  EXPECT_EQ(obstacles[0], (semantics::Obstacle{semantics::Obstacle::Kind::active, "R/A", "a"}));
  EXPECT_EQ(checkpoint_json(*execution), before);
  EXPECT_FALSE(execution->is_edited());
}

TEST_F(EditedRun, GoesOnToTheSameGoalUnderAnotherNumber) {
  execution->set_goal(goal(Goal::Kind::entered, "R/B"));
  change(kNewNames);
  EXPECT_THAT(edit(), IsEmpty());
  EXPECT_TRUE(execution->has_goal());
  EXPECT_TRUE(event("go").reached_goal);
  EXPECT_EQ(active(), R"(["R","R/C"])");
}

TEST_F(EditedRun, StopsWithTheEditThatTakesItsGoalAway) {
  event("go");
  execution->set_goal(goal(Goal::Kind::entered, "R/A"));
  change(kWithoutA);
  EXPECT_THAT(edit(), IsEmpty());
  EXPECT_TRUE(last.reached_goal);
  EXPECT_FALSE(execution->has_goal());
  EXPECT_FALSE(event("tick").reached_goal) << "the goal was given up with the edit, not with the next step";
}

TEST_F(EditedRun, KeepsBreakpointsOfWhatThereIs) {
  execution->set_breakpoints(
      {goal(Goal::Kind::fired, "R/A.go"), goal(Goal::Kind::left, "R/B"), goal(Goal::Kind::entered, "R/A")});
  EXPECT_TRUE(event("go").reached_goal);
  take(execution->continue_step());
  journal.entries.pop_back();
  change(kWithoutA);
  EXPECT_THAT(edit(), IsEmpty());
  EXPECT_FALSE(event("tick").reached_goal);
  EXPECT_TRUE(event("go").reached_goal) << "B is left";
}

TEST_F(EditedRun, KeepsWaitingInputsThatTheModelNames) {
  execution->post_event("t", "tick", 1);
  execution->post_event("t", "go", 2);
  execution->post_response(1, true, 3);
  change(R"([{'op': 'remove', 'id': 'count'}])");
  EXPECT_THAT(edit(), IsEmpty());
  ASSERT_EQ(execution->waiting().size(), 2U);
  EXPECT_EQ(take(execution->step(kRecorded)).entry, JournalEntry(EventEntry{"t", "go", 2}));
  EXPECT_EQ(take(execution->step(kRecorded)).entry, JournalEntry(ResponseEntry{1, "t", "f", true, 3}));
  EXPECT_EQ(execution->run().outcome(), "over");
}

TEST_F(EditedRun, KeepsTheNewestOfWhatIsSampledNow) {
  for (const int data : {1, 2}) execution->post_event("t", "tick", data);
  services["t"].events[1].sampled = true;
  change(R"([{'op': 'set', 'id': 'a', 'field': 'doc', 'value': 'x'}])");
  EXPECT_THAT(edit(), IsEmpty());
  ASSERT_EQ(execution->waiting().size(), 1U);
  EXPECT_EQ(execution->waiting().inputs()[0].data, Value(2));
}

TEST_F(EditedRun, TellsWatchersToLookAnew) {
  execution->watch();
  change(kNewNames);
  const EditEntry entry = this->entry();
  const auto progress = execution->edit(entry, edited(execution->model(), entry).value(), kRecorded);
  EXPECT_TRUE((*progress)->edited);
  EXPECT_FALSE(event("tick").edited);
  EXPECT_EQ(*execution->watch().find("active"), *execution->run().state_json().find("active"));
  const Progress left = event("go");
  EXPECT_EQ(to_json(*left.delta.find("active")), R"({"R/C":true,"R/A":false})");
  const auto forced = execution->force({Force::Scope::var, "R", "n", 9}, kRecorded);
  EXPECT_EQ(to_json(*(*forced)->delta.find("variables")), R"({"R":{"n":9}})");
}

TEST_F(EditedRun, HasEntriesThatAnyThreadMayRead) {
  services.emplace("robot", service(kRobot));
  change(kNewNames);
  EditEntry entry = this->entry();
  Value& robot = *entry.services.find(Value("robot"));
  const Dict* before = &robot.as_dict();
  EXPECT_NE(&robot.mutable_dict(), before) << "nobody else has it: only what is frozen is copied by a change";
}

// Each level of links is two levels of JSON in the native model: more of them than a document may have.
TEST(EditBetween, ChangesStatesThatStandDeeperThanADocument) {
  constexpr int kLevels = 40;
  static_assert(2 * kLevels > JsonLimits{}.depth);
  rcm::Document document =
      rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R", "meta": {"id": "r"}}})").value();
  const auto link_to = [](int level) {
    rcm::State link;
    link.name = "S";
    link.link = "L" + std::to_string(level);
    link.meta.id = "s" + std::to_string(level);
    return link;
  };
  document.root.children.emplace_back(link_to(1));
  for (int level = 1; level <= kLevels; ++level) {
    rcm::State& state = document.library.emplace_back();
    state.name = "L" + std::to_string(level);
    state.meta.id = "l" + std::to_string(level);
    if (level < kLevels) state.children.emplace_back(link_to(level + 1));
  }
  const auto native = [&] { return rcm::write_native(document, rcm::translate(document).value()); };
  const ExecutedModel before = build_model(native(), {}, "native").value();
  document.library.back().entry = "var.x = 1";
  document.library.back().children.emplace_back(rcm::Barrier{"B", {}, {"b", {}}});
  const auto entry = edit_between(before, native(), {});
  ASSERT_TRUE(entry) << to_string(entry.error());
  EXPECT_EQ(entry->edit.operations.size(), 2U);
  const auto after = edited(before, *entry);
  ASSERT_TRUE(after) << to_string(after.error().front());
  EXPECT_EQ(after->native, native());
}

TEST_F(EditedRun, TakesAForceOnlyOnceItHasBegun) {
  Execution fresh = Execution::create(journal.header).value();
  EXPECT_EQ(fresh.force({Force::Scope::var, "R", "n", 1}, {}).error().code, ErrorCode::conflict);
  EXPECT_EQ(fresh.replay(entry(), {}).error().code, ErrorCode::conflict);
  EXPECT_EQ(fresh.replay(ForceEntry{{Force::Scope::var, "R", "n", 1}}, {}).error().code, ErrorCode::conflict);
}

TEST_F(EditedRun, TakesAForcedPortWhateverIsRecorded) {
  Execution unrecorded = *execution;
  force({Force::Scope::port, "R/A", "go"});
  ASSERT_TRUE(unrecorded.force({Force::Scope::port, "R/A", "go"}, {.entry = false}));
  EXPECT_EQ(active(), R"(["R","R/B"])");
  EXPECT_EQ(unrecorded.run().state_json(), execution->run().state_json());
}

// ---- Journal, replay, checkpoint, script.

TEST_F(EditedRun, IsTheSameFromItsJournal) {
  run();
  const Value json = parse_json(to_json(journal_json(journal)), kJournalLimits).value();
  const auto read = read_journal(json);
  ASSERT_TRUE(read) << to_string(read.error()[0]);
  EXPECT_EQ(read->entries, journal.entries);
  EXPECT_THAT(derived_steps(*read).value(), testing::ElementsAreArray(steps));
  const auto& edit = std::get<EditEntry>(journal.entries[2]);
  EXPECT_EQ(edit.revision, 7);
  EXPECT_EQ(
      to_json(Value(edit.services)),
      R"({"robot":{"operations":[{"name":"move"},{"name":"halt","safe":true}],"events":[{"name":"force","sampled":true}]}})");
}

TEST_F(EditedRun, IsTheSameFromItsScript) {
  run();
  const auto script = read_script(script_json(journal));
  ASSERT_TRUE(script) << to_string(script.error()[0]);
  const auto native = rcm::read_document(*journal.header.native.find("document")).value();
  const auto derived = derive(native, *script);
  ASSERT_TRUE(derived) << to_string(derived.error()[0]);
  EXPECT_THAT(derived->find("steps")->as_list(), testing::ElementsAreArray(steps));
}

// From the execution at any position, kept or as a checkpoint, before and after the edit.
TEST_F(EditedRun, IsTheSameFromEveryCheckpoint) {
  run();
  Execution live = Execution::create(journal.header).value();
  for (std::size_t from = 0; from < journal.entries.size(); ++from) {
    live.replay(journal.entries[from], {}).value();
    const std::string text = to_json(checkpoint_json(live));
    EXPECT_EQ(live.is_edited(), from >= 2);
    auto read = read_checkpoint(journal.header, parse_json(text, kJournalLimits).value());
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(to_json(checkpoint_json(*read)), text);
    EXPECT_EQ(read->model().revision, from >= 2 ? 7 : 0);
    for (std::size_t i = from + 1; i < journal.entries.size(); ++i) {
      const Progress& progress = *read->replay(journal.entries[i], kRecorded).value();
      EXPECT_EQ(derived_step(*read, progress), steps[i]) << "from " << from << " to " << i;
    }
  }
  Replay replay(journal.header, std::make_shared<MemoryJournal>(journal.entries), 1);
  for (std::uint64_t to = journal.entries.size(); to > 0; --to)
    EXPECT_EQ(replay.after(to).value().run().state_json(), *steps[to - 1].find("state"));
}

TEST_F(EditedRun, CallsWhatIsSafeOfAServiceThatCameWithAnEdit) {
  run();
  const auto& calls = execution->abort().calls;
  ASSERT_EQ(calls.size(), 2U);
  EXPECT_EQ(calls[1].service + "." + calls[1].name, "robot.halt");
}

TEST_F(EditedRun, RefusesAnEditOfAnotherModel) {
  for (const char* operations :
       {R"([{"op": "remove", "id": "nobody"}])", R"([{"op": "remove", "id": "b"}])",
        R"([{"op": "set", "id": "r", "field": "first", "value": "B"}, {"op": "remove", "id": "a"}])"}) {
    EditEntry entry;
    entry.edit = edit::read_edit(Dict{{"operations", parse_json(operations).value()}}).value();
    const Value before = checkpoint_json(*execution);
    const auto refused = execution->replay(entry, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::conflict);
    EXPECT_EQ(checkpoint_json(*execution), before);
  }
}

TEST_F(EditedRun, ACheckpointOfAnEditedModelHasBegun) {
  run();
  const Value edited = checkpoint_json(*execution);
  Value fresh = checkpoint_json(Execution::create(journal.header).value());
  fresh.mutable_dict().set("model", *edited.find("model"));
  const auto read = read_checkpoint(journal.header, fresh);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().path, "model");
  EXPECT_EQ(read.error().code, ErrorCode::conflict);
}

// ---- Refusals of entries.

struct Refusal {
  std::string input;  // with ' for "
  std::string path;
  ErrorCode code;
};
void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.input; }

class RefusedEntry : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedEntry, WithPathAndCode) {
  std::string input = GetParam().input;
  std::ranges::replace(input, '\'', '"');
  const JournalEntry start = StartEntry{};
  const auto read = read_input(parse_json(input, kJournalLimits).value(), &start);
  ASSERT_FALSE(read);
  std::string all;
  for (const Error& error : read.error()) all += to_string(error) + "\n";
  EXPECT_EQ(read.error().size(), 1U) << all;
  EXPECT_EQ(read.error().front().path, GetParam().path) << all;
  EXPECT_EQ(read.error().front().code, GetParam().code) << all;
}

std::string edit_with(const std::string& more) { return "{'kind': 'edit', 'edit': {'operations': []}, " + more + "}"; }
std::string force_of(const std::string& fields) { return "{'kind': 'force', 'force': {" + fields + "}}"; }

using enum ErrorCode;
INSTANTIATE_TEST_SUITE_P(
    Edits, RefusedEntry,
    testing::Values(
        Refusal{"{'kind': 'edit'}", "input/edit", missing}, Refusal{"{'kind': 'edit', 'edit': 1}", "input/edit", type},
        Refusal{"{'kind': 'edit', 'edit': {}}", "input/edit/operations", missing},
        Refusal{"{'kind': 'edit', 'edit': {'operations': [{'op': 'swap'}]}}", "input/edit/operations/0/op", name},
        Refusal{edit_with("'more': 1"), "input/more", unknown_field},
        Refusal{edit_with("'revision': 0"), "input/revision", out_of_range},
        Refusal{edit_with("'revision': '1'"), "input/revision", type},
        Refusal{edit_with("'origin': []"), "input/origin", type},
        Refusal{edit_with("'origin': {'R': 1}"), "input/origin/R", type},
        Refusal{edit_with("'services': 1"), "input/services", type},
        Refusal{edit_with("'services': {'t': null}"), "input/services/t", type},
        Refusal{edit_with("'services': {'t': {'operations': []}}"), "input/services/t/events", missing},
        Refusal{edit_with("'services': {'t': {'operations': [{'name': 'f', 'safe': 1}], 'events': []}}"),
                "input/services/t/operations/0/safe", type},
        Refusal{edit_with("'services': {'t': {'operations': [], 'events': [{'name': 'a'}, {'name': 'a'}]}}"),
                "input/services/t", duplicate}));
INSTANTIATE_TEST_SUITE_P(
    Forces, RefusedEntry,
    testing::Values(
        Refusal{"{'kind': 'force'}", "input/force", missing},
        Refusal{"{'kind': 'force', 'force': []}", "input/force", type},
        Refusal{force_of("'scope': 'var', 'name': 'n', 'value': 1"), "input/force/path", missing},
        Refusal{force_of("'path': 'R', 'name': 'n', 'value': 1"), "input/force/scope", missing},
        Refusal{force_of("'path': 'R', 'scope': 'chi', 'name': 'n', 'value': 1"), "input/force/scope", type},
        Refusal{force_of("'path': 'R', 'scope': 'var', 'value': 1"), "input/force/name", missing},
        Refusal{force_of("'path': 1, 'scope': 'var', 'name': 'n', 'value': 1"), "input/force/path", type},
        Refusal{force_of("'path': 'R', 'scope': 'var', 'name': 'n'"), "input/force/value", missing},
        Refusal{force_of("'path': 'R', 'scope': 'var', 'name': 'n', 'value': " + std::string(65, '[') +
                         std::string(65, ']')),
                "input/force/value", too_deep},
        Refusal{force_of("'path': 'R', 'scope': 'port', 'name': 'go', 'value': 1"), "input/force/value", unknown_field},
        Refusal{force_of("'path': 'R', 'scope': 'port', 'name': 'go', 'more': 1"), "input/force/more", unknown_field}));

TEST(RefusedForce, HasANumberOutOfRange) {
  const JournalEntry start = StartEntry{};
  const Value value = List{Value::unknown()};  // as parse_json gives one
  const auto read = read_input(
      Dict{{"kind", "force"}, {"force", Dict{{"path", "R"}, {"scope", "var"}, {"name", "n"}, {"value", value}}}},
      &start);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().front().path, "input/force/value");
  EXPECT_EQ(read.error().front().code, constant);
}

// ---- Entries between two models.

TEST(EditBetween, AnyTwoModelsGivesTheSecond) {
  for (std::uint64_t seed = 1; seed <= sample(60); ++seed) {
    SCOPED_TRACE(seed);
    const Journal from = journal_of(edit::random_document(seed), semantics::RandomModels::services());
    const Journal to = journal_of(edit::random_document(seed + 1000), semantics::RandomModels::services());
    const ExecutedModel before{from.header.native, from.header.program, 0};
    const auto entry = edit_between(before, to.header.native, semantics::RandomModels::services());
    ASSERT_TRUE(entry) << to_string(entry.error());
    EXPECT_THAT(entry->services, IsEmpty());
    const auto after = edited(before, *entry);
    ASSERT_TRUE(after) << to_string(after.error()[0]);
    EXPECT_TRUE(after->native == to.header.native);
    EXPECT_TRUE(edit_between(*after, to.header.native, {}).value().edit.operations.empty());
  }
}

}  // namespace
}  // namespace race::execution
