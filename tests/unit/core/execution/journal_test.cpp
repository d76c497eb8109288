// The journal codec: what is written is read back, and what is no journal is refused, with path and code.
#include "core/execution/journal.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "core/execution/script.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

Journal read_back(const Journal& journal) {
  const auto json = parse_json(to_json(journal_json(journal)), kJournalLimits);
  const auto read = read_journal(json.value());
  EXPECT_TRUE(read) << (read ? "" : to_string(read.error().front()));
  return read.value_or(journal);
}

void expect_equal(const Journal& read, const Journal& written) {
  EXPECT_EQ(read.entries, written.entries);
  EXPECT_EQ(read.header.native, written.header.native);
  EXPECT_EQ(read.header.arguments, written.header.arguments);
  EXPECT_EQ(read.header.budgets.evaluation.steps, written.header.budgets.evaluation.steps);
  EXPECT_EQ(read.header.budgets.evaluation.value_units, written.header.budgets.evaluation.value_units);
  EXPECT_EQ(read.header.budgets.micro_steps, written.header.budgets.micro_steps);
  EXPECT_NE(read.header.program, written.header.program);
  EXPECT_EQ(to_json(journal_json(read)), to_json(journal_json(written)));
}

TEST(Journal, IsReadBackAsItWasWritten) {
  expect_equal(read_back(small_journal()), small_journal());
  Journal unstarted = small_journal();
  unstarted.entries.clear();
  expect_equal(read_back(unstarted), unstarted);
}

TEST(Journal, OfARunThatWasAbortedBeforeItsFirstMacroStepHasNoStart) {
  Journal aborted = small_journal();
  aborted.entries = {AbortEntry{}};
  expect_equal(read_back(aborted), aborted);
}

TEST(Journal, IsWrittenByNames) {
  const Value json = journal_json(small_journal());
  const List& entries = json.find("entries")->as_list();
  EXPECT_EQ(to_json(entries[0]), R"({"position":1,"input":{"kind":"start"}})");
  EXPECT_EQ(to_json(entries[1]), R"({"position":2,"input":{"kind":"response","service":"w","operation":"go","call":1,)"
                                 R"("error":{"code":"unavailable"}}})");
  EXPECT_EQ(to_json(entries[2]),
            R"({"position":3,"input":{"kind":"event","service":"t","event":"tick","data":{"x":1.0}}})");
  EXPECT_EQ(to_json(entries[3]),
            R"({"position":4,"input":{"kind":"response","service":"t","operation":"wait","call":2,"result":null}})");
  EXPECT_EQ(to_json(entries[5]), R"({"position":6,"input":{"kind":"abort"}})");
  EXPECT_EQ(to_json(*json.find("header")->find("services")->find("t")),
            R"({"operations":[{"name":"wait"},{"name":"stop","safe":true}],)"
            R"("events":[{"name":"tick","sampled":true},{"name":"unread"}]})");
  EXPECT_EQ(to_json(*json.find("header")->find("budgets")),
            R"({"steps":1000000,"value_units":1000000,"micro_steps":500,"work":10000000,"calls":5000,)"
            R"("output_units":1000000,"data_units":4000000})");
}

TEST(Journal, HasEditsAndForcesByNames) {
  const EditEntry edit{{{edit::Remove{"a"}}}, Dict{{"R/A", nullptr}}, Dict{{"t", Dict{{"events", List{}}}}}, 7};
  EXPECT_EQ(to_json(input_json(edit)),
            R"({"kind":"edit","revision":7,"edit":{"operations":[{"op":"remove","id":"a"}]},)"
            R"("origin":{"R/A":null},"services":{"t":{"events":[]}}})");
  EXPECT_EQ(to_json(input_json(EditEntry{edit.edit, {}, {}})),
            R"({"kind":"edit","edit":{"operations":[{"op":"remove","id":"a"}]}})");
  using semantics::Force;
  EXPECT_EQ(to_json(input_json(ForceEntry{{Force::Scope::var, "R", "n", 1}})),
            R"({"kind":"force","force":{"path":"R","scope":"var","name":"n","value":1}})");
  EXPECT_EQ(to_json(input_json(ForceEntry{{Force::Scope::port, "R/A", "go"}})),
            R"({"kind":"force","force":{"path":"R/A","scope":"port","name":"go"}})");
}

TEST(Journal, AsAScriptHasAStepForEachEntryButTheAbort) {
  const Journal journal = small_journal();
  const Value json = script_json(journal);
  EXPECT_EQ(to_json(*json.find("steps")),
            R"([{},{"responses":[{"service":"w","operation":"go","call":1,"error":{"code":"unavailable"}}]},)"
            R"({"events":[{"service":"t","event":"tick","data":{"x":1.0}}]},)"
            R"({"responses":[{"service":"t","operation":"wait","call":2,"result":null}]},)"
            "{\"events\":[{\"service\":\"t\",\"event\":\"tick\",\"data\":{\"x\":[1,\"\\n\u00e9\",null]}}]}]");
  EXPECT_TRUE(read_script(json));
}

TEST(Journal, OfTheExamplesIsReadBackAsItStandsThere) {
  std::ostringstream text;
  text << std::ifstream(RACE_SOURCE_DIR "/api/examples/journal.small.json").rdbuf();
  const Value json = parse_json(text.str(), kJournalLimits).value();
  const auto journal = read_journal(json);
  ASSERT_TRUE(journal) << to_string(journal.error().front());
  EXPECT_EQ(to_json(journal_json(*journal), 1), to_json(json, 1));
}

// The deepest native model that documents may have.
TEST(Journal, OfTheDeepestModelIsReadBack) {
  rcm::Document document;
  document.root.name = "S";
  for (std::size_t level = 1; level < rcm::kMaxDepth; ++level) {
    rcm::State parent;
    parent.name = "S";
    parent.children.emplace_back(std::move(document.root));
    document.root = std::move(parent);
  }
  const Journal journal = journal_of(document, {});
  expect_equal(read_back(journal), journal);
}

TEST(Journal, OfARandomRunIsReadBackAndGivesThatRunAgain) {
  const std::uint64_t seed = setting("RACE_SEED", 20261122);
  const std::uint64_t journals = setting("RACE_JOURNALS", 150);
  std::cout << "RACE_SEED=" << seed << " RACE_JOURNALS=" << journals << std::endl;
  std::size_t entries = 0;
  for (std::uint64_t i = 0; i < journals && !HasFailure(); ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed + i));
    const auto [journal, execution] = random_journal(seed + i, 40);
    const Journal read = read_back(journal);
    expect_equal(read, journal);
    auto again = Execution::create(read.header.program, read.header.arguments, read.header.budgets).value();
    for (const JournalEntry& entry : read.entries) EXPECT_TRUE(again.replay(entry, {}));
    EXPECT_EQ(again.run().status(), execution.run().status());
    EXPECT_EQ(to_json(again.run().state_json()), to_json(execution.run().state_json()));
    EXPECT_EQ(again.run().state().call_count, execution.run().state().call_count);
    entries += read.entries.size();
  }
  EXPECT_GT(entries, journals * 10);
}

// ---- Refusals.

// Sets the field at `path` (names, and numbers of items) to `value`; unknown removes it.
Value with(const Value& json, std::string_view path, const Value& value) {
  const auto slash = path.find('/');
  const std::string_view key = path.substr(0, slash);
  const bool last = slash == std::string_view::npos;
  const std::string_view rest = last ? "" : path.substr(slash + 1);
  Value out = json;
  if (json.is_list()) {
    const auto at = std::stoul(std::string(key));
    List& items = out.mutable_list();
    if (at == items.size()) items.emplace_back();
    items[at] = last ? value : with(json.as_list()[at], rest, value);
  } else if (last && value.is_unknown()) {
    out.mutable_dict().erase(key);
  } else {
    const Value* field = json.find(key);
    out.mutable_dict().set(key, last ? value : with(field ? *field : Value(Dict()), rest, value));
  }
  return out;
}

Value nested(std::size_t levels) {
  Value value;
  for (; levels > 0; --levels) value = List{std::move(value)};
  return value;
}

struct Refusal {
  std::string at;  // what is changed in the small journal
  Value to;        // unknown: it is removed
  std::string path;
  ErrorCode code;
};
void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.at; }

const Value kRemoved = Value::unknown();
const Value kEvent = Dict{{"kind", "event"}, {"service", "t"}, {"event", "tick"}, {"data", nullptr}};
const Value kResponse = Dict{{"kind", "response"}, {"service", "t"}, {"operation", "wait"}, {"call", 3}};
const std::string kOrigins = "header/native/origin";
const std::string kDocument = "header/native/document";

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithPathAndCode) {
  const Refusal& refusal = GetParam();
  const auto read = read_journal(with(journal_json(small_journal()), refusal.at, refusal.to));
  ASSERT_FALSE(read);
  std::string all;
  for (const Error& error : read.error()) all += to_string(error) + "\n";
  EXPECT_EQ(read.error().size(), 1U) << all;
  EXPECT_EQ(read.error().front().path, refusal.path) << all;
  EXPECT_EQ(read.error().front().code, refusal.code) << all;
}

using enum ErrorCode;
const Refusal kOfTheHeader[] = {
    {"header", kRemoved, "header", missing},
    {"header", 1, "header", type},
    {"header/more", 1, "header/more", unknown_field},
    {"more", 1, "more", unknown_field},
    {"header/semantics", kRemoved, "header/semantics", missing},
    {"header/semantics", "2", "header/semantics", version},
    {"header/semantics", 1, "header/semantics", version},
    {"header/budgets", kRemoved, "header/budgets", missing},
    {"header/budgets/steps", kRemoved, "header/budgets/steps", missing},
    {"header/budgets/steps", 0, "header/budgets/steps", out_of_range},
    {"header/budgets/value_units", 1.0, "header/budgets/value_units", type},
    {"header/budgets/micro_steps", std::int64_t{1} << 32, "header/budgets/micro_steps", out_of_range},
    {"header/budgets/seconds", 1, "header/budgets/seconds", unknown_field},
    {"header/arguments", kRemoved, "header/arguments", missing},
    {"header/arguments", List{}, "header/arguments", type},
    {"header/arguments/nobody", 1, "header/arguments/nobody", unknown_name},
    {"header/arguments/key", List{Value::unknown()}, "header/arguments", constant},
    {"header/arguments/key", nested(64), "header/arguments", too_deep},
    {"header/services", kRemoved, "header/services", missing},
    {"header/services", List{}, "header/services", type},
    {"header/services/t", 1, "header/services/t", type},
    {"header/services/t/events", kRemoved, "header/services/t/events", missing},
    {"header/services/t/states", List{}, "header/services/t/states", unknown_field},
    {"header/services/t/operations/0", "wait", "header/services/t/operations/0", type},
    {"header/services/t/operations/1/name", kRemoved, "header/services/t/operations/1/name", missing},
    {"header/services/t/operations/1/name", "wait", "header/services/t", duplicate},
    {"header/services/t/operations/1/name", "to wait", "header/services/t", name},
    {"header/services/t/operations/0/safe", 1, "header/services/t/operations/0/safe", type},
    {"header/services/t/operations/0/sampled", true, "header/services/t/operations/0/sampled", unknown_field},
    {"header/native", kRemoved, "header/native", missing},
    {"header/native", 1, "header/native", type},
    {"header/native/more", 1, "header/native/more", unknown_field},
    {kDocument, kRemoved, kDocument, missing},
    {kDocument, 1, kDocument, type},
    {kDocument + "/rcm", 2, kDocument, version},
    {kDocument + "/root/first", "C", kDocument + "/Root", first},
    {kDocument + "/root/ports/0/when", "svc.t.tick.x >", kDocument + "/Root.over", syntax},
    {kDocument + "/library", List{Dict{{"state", "L"}}}, kDocument + "/library", unknown_field},
    {kDocument + "/root/oracle", Dict{{"kind", "expr"}, {"expr", "'A'"}}, kDocument + "/Root", duplicate},
    {kDocument + "/root/children/1", Dict{{"state", "A"}, {"link", "L"}}, kDocument + "/Root/A", link_unknown},
    {kOrigins, kRemoved, kOrigins, missing},
    {kOrigins, List{}, kOrigins, type},
    {kOrigins + "/Nowhere", "Root", kOrigins + "/Nowhere", unknown_name},
};
INSTANTIATE_TEST_SUITE_P(Headers, Refused, testing::ValuesIn(kOfTheHeader));

const Refusal kOfTheEntries[] = {
    {"entries", kRemoved, "entries", missing},
    {"entries", Dict{}, "entries", type},
    {"entries/2", 1, "entries/2", type},
    {"entries/2/more", 1, "entries/2/more", unknown_field},
    {"entries/2/position", kRemoved, "entries/2/position", missing},
    {"entries/2/position", "3", "entries/2/position", type},
    {"entries/2/position", 4, "entries/2/position", out_of_range},
    {"entries/2/position", 0, "entries/2/position", out_of_range},
    {"entries/2/input", kRemoved, "entries/2/input", missing},
    {"entries/2/input", 1, "entries/2/input", type},
    {"entries/2/input/more", 1, "entries/2/input/more", unknown_field},
    {"entries/2/input/kind", kRemoved, "entries/2/input/kind", missing},
    {"entries/2/input", Dict{{"kind", "services"}}, "entries/2/input/kind", type},
    {"entries/2/input", Dict{{"kind", "start"}}, "entries/2/input/kind", type},
    {"entries/2/input", Dict{{"kind", "abort"}}, "entries/3/input/kind", type},
    {"entries/0/input", kEvent, "entries/0/input/kind", type},
    {"entries/6", Dict{{"position", 7}, {"input", kEvent}}, "entries/6/input/kind", type},
    {"entries/2/input/service", kRemoved, "entries/2/input/service", missing},
    {"entries/2/input/service", "s", "entries/2/input/event", unknown_name},
    {"entries/2/input/event", "tock", "entries/2/input/event", unknown_name},
    {"entries/2/input/event", "unread", "entries/2/input/event", unknown_name},
    {"entries/2/input/event", 1, "entries/2/input/event", type},
    {"entries/2/input/data", kRemoved, "entries/2/input/data", missing},
    {"entries/2/input/data", List{Value::unknown()}, "entries/2/input/data", constant},
    {"entries/2/input/data", nested(65), "entries/2/input/data", too_deep},
    {"entries/3/input/call", kRemoved, "entries/3/input/call", missing},
    {"entries/3/input/call", 0, "entries/3/input/call", out_of_range},
    {"entries/3/input/call", 1.0, "entries/3/input/call", type},
    {"entries/3/input/operation", "stop", "entries/3/input/operation", unknown_name},
    {"entries/3/input/service", "w", "entries/3/input/operation", unknown_name},
    {"entries/3/input/result", kRemoved, "entries/3/input", missing},
    {"entries/3/input/error", 1, "entries/3/input", missing},
    {"entries/3/input/event", "tick", "entries/3/input/event", unknown_field},
};
INSTANTIATE_TEST_SUITE_P(Entries, Refused, testing::ValuesIn(kOfTheEntries));

TEST(Journal, ListsAllErrorsOfItsHeaderButOnlyThoseOfTheFirstWrongEntry) {
  Value json = journal_json(small_journal());
  json = with(json, "entries/1/input/call", 0);
  json = with(json, "entries/1/input/service", 1);
  json = with(json, "entries/2/position", 0);
  EXPECT_EQ(read_journal(json).error().size(), 2U);
  json = with(json, "header/budgets/steps", 0);
  json = with(json, "header/arguments", 0);
  EXPECT_EQ(read_journal(json).error().size(), 2U);
}

TEST(Journal, DataOf64LevelsIsRead) {
  EXPECT_TRUE(read_journal(with(journal_json(small_journal()), "entries/2/input/data", nested(64))));
}

}  // namespace
}  // namespace race::execution
