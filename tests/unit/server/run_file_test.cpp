// Files of runs: what is read is what was written, and whatever does not fit together is refused.
#include "server/runs/run_file.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <atomic>
#include <thread>

#include "core/execution/step_json.h"
#include "core/value/json.h"
#include "server/runs/run_json.h"
#include "server/store/digest_column.h"
#include "server/store/journal_chain.h"
#include "server/store/run_row.h"
#include "server/store/statements.h"
#include "server/threads/worker.h"
#include "tests/unit/server/run_store.h"

namespace race::server {
namespace {

using namespace std::string_literals;

/// The file of a run that goes on, whose journal nobody has executed.
RunFile unchecked_file_of(execution::Journal journal) {
  RunFile file;
  file.record.chain = header_chain(journal.header);
  for (const execution::JournalEntry& entry : journal.entries)
    file.record.chain = chain_after(file.record.chain, input_text(entry));
  file.record.id = 12;
  file.record.document = "task";
  file.record.revision = 3;
  file.record.arguments = journal.header.arguments;
  file.record.steps = journal.entries.size();
  file.record.created_ms = 1700000000000;
  file.record.status = "running";
  file.services = {{"t", timer_service()}};
  file.services.at("t").name = "timer";
  Value pose = Dict{{"time", 0.2}, {"joints", Dict{{"a1", 0.5}}}, {"bodies", Dict()}};
  file.samples = {{1, pose.freeze()}};
  file.journal = std::move(journal);
  return file;
}

/// The file of a run as a server that executed it writes it.
RunFile file_of(execution::Journal journal) {
  execution::Execution execution =
      execution::Execution::create(journal.header.program, journal.header.arguments, journal.header.budgets).value();
  for (const execution::JournalEntry& entry : journal.entries) execution.replay(entry, {}).value();
  RunFile file = unchecked_file_of(std::move(journal));
  file.record.status = semantics::name(execution.run().status());
  if (file.record.is_over()) {
    file.record.outcome = execution.run().outcome();
    file.record.results = execution::root_results(execution.run());
    file.record.ended_ms = 1700000001000;
  }
  return file;
}

Value json_of(const RunFile& file) { return parse_json(write_run_file(file).value(), kRunFileLimits).value(); }

/// `json` with another value at `path` ("run/steps"); an unknown one removes the field.
Value changed(const Value& json, std::string_view path, const Value& value) {
  Value out = json;
  const std::string_view key = path.substr(0, path.find('/'));
  const std::string_view rest = path.size() > key.size() ? path.substr(key.size() + 1) : "";
  if (out.is_list()) {
    Value& item = out.mutable_list().at(static_cast<std::size_t>(key.front() - '0'));
    item = rest.empty() ? value : changed(item, rest, value);
    return out;
  }
  if (value.is_unknown() && rest.empty())
    out.mutable_dict().erase(key);
  else
    out.mutable_dict().set(key, rest.empty() ? value : changed(out.find(key) ? *out.find(key) : Value(), rest, value));
  return out;
}

std::pair<ErrorCode, std::string> refusal_of(const Value& json) {
  const auto read = read_run_file(json);
  if (read) return {ErrorCode::json, "was read"};
  return {read.error().front().code, read.error().front().path};
}

TEST(RunFiles, AreReadAsTheyWereWritten) {
  for (const auto& ticks : {std::vector<int>{}, {1, 2}, {60, 60}}) {
    RunFile file = file_of(counting(ticks));
    file.document = parse_json(R"({"rcm": 1, "root": {"state": "Root"}})").value();
    const auto read = read_run_file_text(write_run_file(file).value());
    ASSERT_TRUE(read) << to_string(read.error().front());
    EXPECT_EQ(read->journal.entries, file.journal.entries);
    EXPECT_EQ(json_of(*read).find("journal")->find("header")->find("native")->size_units(),
              file.journal.header.native.size_units());
    EXPECT_EQ(read->record.status, file.record.status);
    EXPECT_EQ(read->record.results, file.record.results);
    EXPECT_EQ(read->services, file.services);
    EXPECT_EQ(read->document, file.document);
    ASSERT_EQ(read->samples.size(), 1u);
    EXPECT_EQ(read->samples[0].pose, file.samples[0].pose);
  }
}

TEST(RunFiles, SayHowManyEntriesWereDoneAgain) {
  constexpr int kTries = 20;  // who looks may be too late, but not each time
  const std::string text = write_run_file(file_of(counting(std::vector<int>(3000, 0)))).value();
  bool on_its_way = false;
  for (int tries = 0; tries < kTries && !on_its_way; ++tries) {
    WorkProgress progress;
    std::atomic<bool> over{false};
    std::thread onlooker([&] {
      while (!over) {
        const auto state = progress.state();
        on_its_way = on_its_way || (state && 0 < state->done && state->done < 3001);
      }
    });
    EXPECT_TRUE(read_run_file_text(text, nullptr, nullptr, &progress));
    over = true;
    onlooker.join();
    EXPECT_EQ(progress.state()->done, 3001U);
    EXPECT_EQ(progress.state()->total, 2 * 3001U) << "they are to be stored, too";
  }
  EXPECT_TRUE(on_its_way);
}

TEST(RunFiles, HoldTheRecordAgainstTheJournal) {
  using Code = ErrorCode;
  const Value json = json_of(file_of(counting({60, 60})));
  const std::string wrong(64, 'a');
  for (const auto& [path, value, code] :
       std::vector<std::tuple<std::string, Value, Code>>{{"run/steps", 2, Code::corrupt},
                                                         {"run/arguments", Dict{{"x", 1}}, Code::corrupt},
                                                         {"run/chain", wrong, Code::corrupt},
                                                         {"run/status", "aborted", Code::corrupt},
                                                         {"run/outcome", "failed", Code::corrupt},
                                                         {"run/results", Dict{{"n", 121}}, Code::corrupt},
                                                         {"run/status", "asleep", Code::type},
                                                         {"run/steps", -1, Code::out_of_range},
                                                         {"run/created", 1.5, Code::out_of_range},
                                                         {"run/chain", Value::unknown(), Code::missing},
                                                         {"run/imported", Value::unknown(), Code::missing},
                                                         {"run/color", 1, Code::unknown_field},
                                                         {"version", 2, Code::version},
                                                         {"journal", Value::unknown(), Code::missing},
                                                         {"journal/entries/1/position", 3, Code::out_of_range},
                                                         {"journal/header/semantics", "0", Code::version},
                                                         {"services/t", 1, Code::type},
                                                         {"services/t", Dict(), Code::missing},
                                                         {"samples/0/pose/joints/a1", nullptr, Code::type},
                                                         {"samples/0/pose/bodies", Dict{{"x", 1}}, Code::type},
                                                         {"samples/0/pose/hands", 1, Code::type},
                                                         {"samples/0/pose/hands", List{Value(1)}, Code::type},
                                                         {"samples/0/pose/time", Value::unknown(), Code::missing},
                                                         {"samples/0/pose/joints", 1, Code::type},
                                                         {"samples/0/step", -1, Code::out_of_range},
                                                         {"document", Dict{{"rcm", 1}}, Code::missing}}) {
    SCOPED_TRACE(path + " = " + (value.is_unknown() ? "" : to_json(value)));
    const auto [found, where] = refusal_of(changed(json, path, value));
    EXPECT_EQ(name(found), name(code)) << where;
    EXPECT_TRUE(where.starts_with(path)) << where;
  }
}

TEST(RunFiles, OfARunInItsLastMacroStepAreOfOneThatIsOver) {
  RunFile file = file_of(counting({100}));
  file.record.status = "running";
  file.record.outcome.clear();
  file.record.results = Value();
  const auto read = read_run_file_text(write_run_file(file).value());
  ASSERT_TRUE(read) << to_string(read.error().front());
  EXPECT_EQ(read->record.status, "ended");
  EXPECT_EQ(read->record.outcome, "done");
  EXPECT_EQ(read->record.results, Value(Dict{{"n", 100}}));
}

TEST(RunFiles, HoldAChangedInputAgainstTheChain) {
  const Value json = json_of(file_of(counting({1, 2})));
  EXPECT_EQ(refusal_of(changed(json, "journal/entries/1/input/data", 2)),
            (std::pair(ErrorCode::corrupt, std::string("run/chain"))));
  EXPECT_EQ(refusal_of(changed(json, "journal/header/native/document/name", "other")),
            (std::pair(ErrorCode::corrupt, std::string("run/chain"))));
}

TEST(RunFiles, AreRefusedIfTheRunDoesNotTakeTheirEntries) {
  RunFile file = file_of(counting({100}));
  file.journal.entries.emplace_back(execution::EventEntry{"t", "tick", 1});  // after the end
  file.record.chain = chain_after(file.record.chain, input_text(file.journal.entries.back()));
  ++file.record.steps;
  EXPECT_EQ(refusal_of(json_of(file)), (std::pair(ErrorCode::conflict, std::string("journal/entries/2"))));
}

TEST(RunFiles, AskForNoMoreWorkThanARunOfThisServer) {
  execution::Journal journal = counting({1});
  journal.header.budgets.micro_steps = semantics::Budgets().micro_steps + 1;
  EXPECT_EQ(refusal_of(json_of(file_of(std::move(journal)))),
            (std::pair(ErrorCode::out_of_range, std::string("journal/header/budgets"))));
}

/// A run whose first macro step takes long, all within the budgets.
execution::Journal hostile(std::string_view root) {
  Dict arguments{{"x", List(40'000, Value(1))}, {"y", List(40'000, Value(1))}};
  const std::string document = R"({"rcm": 1, "root": {"state": "Root", "parameters": [{"name": "x"}, {"name": "y"}], )";
  execution::Journal journal =
      execution::journal_of(rcm::read_document_text(document + std::string(root) + "}}").value(), {}, arguments);
  journal.entries.emplace_back(execution::StartEntry{});
  return journal;
}

// So many ports of a state, none of which fires.
std::string ports(int count, const std::string& when) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += (i == 0 ? "" : ", ") + R"({"name": "p)"s + std::to_string(i) + R"(", "when": ")" + when + R"("})";
  return R"("ports": [)" + text + "]";
}

TEST(RunFiles, AreStoppedWhenTheirRunTakesTooLong) {
  std::string comparisons = "par.x == par.y";
  for (int i = 0; i < 40; ++i) comparisons += " and par.x == par.y";
  const std::string slow = "len([i for i in range(100000)])";
  const auto state = [&](const char* name, const char* to) {
    return R"({"state": ")"s + name + R"(", "ports": [{"name": "p", "when": ")" + slow + R"( > 0", "to": ")" + to +
           R"("}]})";
  };
  for (const std::string& root : {ports(400, slow + " < 0"), ports(400, comparisons + " and False"),
                                  R"("first": "A", "children": [)" + state("A", "B") + ", " + state("B", "A") + "]"}) {
    SCOPED_TRACE(root.substr(0, 100));
    const std::string text = write_run_file(unchecked_file_of(hostile(root))).value();
    Deadlines deadlines;
    Worker worker(deadlines);
    const auto ask = [&](std::chrono::milliseconds limit, const std::function<bool(const Stop&)>& read) {
      return wait_for<bool>([&](Done<bool> done) {
        worker.ask<bool>(read, {limit, {ErrorCode::too_large, ""}}, std::make_shared<Stop>(false), std::move(done));
      });
    };
    const auto read = [&](const Stop& stop) { return read_run_file_text(text, nullptr, &stop).has_value(); };
    EXPECT_EQ(ask(std::chrono::milliseconds(50), read).error().code, ErrorCode::too_large);
    EXPECT_TRUE(ask(std::chrono::seconds(1), [](const Stop&) { return true; })) << "it is still busy";
  }
}

class FilesOfStoredRuns : public StoredRuns {};

TEST_F(FilesOfStoredRuns, ReadNoLongerJournalThanAFileHasRoomFor) {
  const auto runs = open();
  execution::Journal journal = counting({});
  std::size_t bytes = input_text(journal.entries[0]).size();
  const auto add = [&](std::size_t size) {
    journal.entries.emplace_back(execution::EventEntry{"t", "tick", std::string(size, 'x')});
    bytes += input_text(journal.entries.back()).size();
  };
  for (int i = 0; i < 15; ++i) add(1 << 20);
  const std::size_t around = input_text(execution::EventEntry{"t", "tick", ""}).size();
  add(kRunFileLimits.bytes - bytes - around);
  ASSERT_EQ(bytes, kRunFileLimits.bytes);
  const auto whole = journal_of(import(*runs, journal), *runs);
  ASSERT_TRUE(whole) << to_string(whole.error());
  EXPECT_EQ(whole->entries.size(), journal.entries.size());
  journal.entries.emplace_back(execution::EventEntry{"t", "tick", 1});
  const auto longer = journal_of(import(*runs, journal), *runs);
  ASSERT_FALSE(longer);
  EXPECT_EQ(longer.error().code, ErrorCode::too_large);
  EXPECT_NE(longer.error().message.find("race replay"), std::string::npos) << "what to do instead";
}

TEST(RunFiles, ThatAreTextsHaveTheSameBound) {
  const std::string longest(kRunFileLimits.bytes - 2, 'x');
  EXPECT_EQ(bounded_text(longest)->size(), kRunFileLimits.bytes);
  EXPECT_EQ(bounded_text(longest + 'x').error().code, ErrorCode::too_large);
}

TEST_F(FilesOfStoredRuns, NameAnRsmThatCannotBeRead) {
  const auto runs = open();
  RunRecord run = runs->create(run_of(counting({})), 1).value();
  EXPECT_EQ(services_of(run.id, *runs).value(), (std::map<std::string, rsm::Service>{{"t", timer_service()}}));
  const std::string other = R"({"t":{"events":1}})";
  run.services = sqlite::sha256(other);
  SQLite::Database file(path(), SQLite::OPEN_READWRITE);
  SQLite::Statement insert(file, "INSERT INTO header VALUES (?, ?)");
  bind_digest(insert, 1, run.services);
  insert.bind(2, other);
  insert.exec();
  Statements statements(file);
  ASSERT_TRUE(update_row(statements, run));
  const auto read = services_of(run.id, *runs);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  EXPECT_EQ(read.error().path, "services/t");
}

TimingBlock timing_of_two() {
  TimingBlock block;
  block.steps = {{10, {}}, {20, Arrival{15, {1, Moment::kEnd}}}};
  block.since = {0, 0};
  block.until = {2, Moment::kEnd};
  block.services = {{5, "t", "Idle"}};
  return block;
}

TEST(RunFiles, HaveTheTimesOfTheirRun) {
  RunFile file = file_of(counting({1}));
  EXPECT_EQ(json_of(file).find("timing"), nullptr);
  file.timing = {timing_of_two()};
  EXPECT_EQ(read_run_file(json_of(file))->timing, file.timing);
  EXPECT_EQ(refusal_of(changed(json_of(file), "timing/0/first", 2)),
            (std::pair(ErrorCode::out_of_range, std::string("timing/0/first"))));
  EXPECT_EQ(refusal_of(changed(json_of(file), "timing/0/steps", "x")).second, "timing/0/steps");
  file.timing.resize(TimingBlock::kMostBlocks + 1, file.timing[0]);
  EXPECT_EQ(refusal_of(json_of(file)), (std::pair(ErrorCode::too_large, std::string("timing"))));
}

TEST(RunFiles, HaveThePicturesOfTheirRun) {
  RunFile file = file_of(counting({1}));
  EXPECT_EQ(json_of(file).find("pictures"), nullptr);
  file.pictures = {{"camera", 1, 0.5, "AAAA"}, {"camera", 2, 1, "BBBB"}};
  const Value json = json_of(file);
  const auto read = read_run_file(json)->pictures;
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(Value(picture_json(read[1])), Value(picture_json(file.pictures[1])));
  EXPECT_EQ(refusal_of(changed(json, "pictures/1/jpeg", "<svg>")).second, "pictures/1/jpeg");
  EXPECT_EQ(refusal_of(changed(json, "pictures/1/jpeg", std::string(Pictures::kLongest + 4, 'A'))).second,
            "pictures/1/jpeg");
  EXPECT_EQ(refusal_of(changed(json, "pictures/0/service", std::string(101, 'a'))).second, "pictures/0/service");
  EXPECT_EQ(refusal_of(changed(json, "pictures/0/step", -1)).second, "pictures/0/step");
  file.pictures.resize(Pictures::kMost + 1, file.pictures[0]);
  EXPECT_EQ(refusal_of(json_of(file)), (std::pair(ErrorCode::too_large, std::string("pictures"))));
}

TEST(RunFiles, LeavePicturesOutBeforeTimesIfThereIsNoRoom) {
  RunFile file = file_of(counting({1}));
  file.timing = {timing_of_two()};
  const std::size_t bytes = write_run_file(file)->size();
  file.pictures = {{"camera", 1, 0.5, "AAAA"}};
  file.record.document = "task" + std::string(kRunFileLimits.bytes - bytes, 'x');
  EXPECT_NE(json_of(file).find("timing"), nullptr);
  EXPECT_EQ(json_of(file).find("pictures"), nullptr);
}

TEST(RunFiles, LeaveTimesOutForWhichThereIsNoRoom) {
  RunFile file = file_of(counting({1}));
  file.timing = {timing_of_two()};
  const std::size_t bytes = write_run_file(file)->size();
  file.record.document = "task" + std::string(kRunFileLimits.bytes - bytes, 'x');
  EXPECT_NE(json_of(file).find("timing"), nullptr);
  file.record.document += 'x';
  EXPECT_EQ(json_of(file).find("timing"), nullptr);
}

TEST(RunFiles, HaveABound) {
  RunFile file = file_of(counting({1}));
  Value pose = Dict{{"time", 0.2}, {"joints", Dict{{std::string(15 << 20, 'x'), 0.5}}}, {"bodies", Dict()}};
  file.samples = {{1, pose.freeze()}};
  const std::string text = write_run_file(file).value();
  EXPECT_TRUE(read_run_file_text(text));
  const std::size_t room = kRunFileLimits.bytes - text.size();
  file.record.document = "task" + std::string(room, 'x');
  EXPECT_EQ(write_run_file(file)->size(), kRunFileLimits.bytes);
  file.record.document += 'x';
  EXPECT_EQ(write_run_file(file).error().code, ErrorCode::too_large);
  EXPECT_EQ(read_run_file_text(text + std::string(room + 1, ' ')).error().front().code, ErrorCode::too_large);
  file = file_of(counting({1}));
  file.samples.resize(Samples::kMost + 1, file.samples[0]);
  EXPECT_EQ(refusal_of(json_of(file)), (std::pair(ErrorCode::too_large, std::string("samples"))));
}

}  // namespace
}  // namespace race::server
