// The times of runs in the store: kept in order, bounded, gone with their run; and as the file of a run has them.
#include "server/store/timing.h"

#include <SQLiteCpp/Database.h>

#include "core/value/json.h"
#include "server/store/journal_writer.h"
#include "server/store/run_timing.h"
#include "tests/unit/server/run_store.h"

namespace race::server {
namespace {

TimingBlock block(std::uint64_t first, std::size_t steps) {
  TimingBlock block;
  block.first = first;
  const auto base = static_cast<std::int64_t>(1000 * first);
  for (std::size_t i = 0; i < steps; ++i) block.steps.push_back({base + static_cast<std::int64_t>(i), {}});
  block.begins = base;
  block.ends = base + 500;
  block.since = {0, 0};
  block.until = {first + steps - 1, Moment::kEnd};
  return block;
}

TimingBlock full_block() {
  TimingBlock full = block(3, 2);
  full.steps[1].input = {7, {3, 2}};
  full.undelivered = {{execution::EventEntry{"t", "tick", Dict{{"x", 1.5}}}, {8, {3, Moment::kEnd}}, {4, 1}},
                      {execution::ResponseEntry{2, "t", "wait", true, "late"}, {9, {4, 0}}, {4, Moment::kEnd}}};
  full.services = {{1, "t", "Idle"}, {5, "t", std::nullopt}};
  return full;
}

Value changed(const TimingBlock& block, std::string_view key, const Value& value) {
  Value json = timing_json(block);
  json.mutable_dict().set(key, value);
  return json;
}

std::pair<ErrorCode, std::string> timing_refusal(const Value& json) {
  std::vector<Error> errors;
  read_timing(json, "timing/0", errors);
  return errors.empty() ? std::pair(ErrorCode::json, std::string("was read"))
                        : std::pair(errors[0].code, errors[0].path);
}

TEST(TimingBlocks, AreReadAsTheyWereWritten) {
  std::vector<Error> errors;
  EXPECT_EQ(read_timing(parse_json(to_json(timing_json(full_block()))).value(), "", errors), full_block());
  EXPECT_TRUE(errors.empty());
}

TEST(TimingBlocks, AreRefusedIfTheySayWhatCannotBe) {
  using Refusal = std::pair<ErrorCode, std::string>;
  const TimingBlock full = full_block();
  EXPECT_EQ(timing_refusal(changed(full, "first", 0)), Refusal(ErrorCode::out_of_range, "timing/0/first"));
  EXPECT_EQ(timing_refusal(changed(full, "steps", List{Value(List{-1})})),
            Refusal(ErrorCode::out_of_range, "timing/0/steps/0"));
  EXPECT_EQ(timing_refusal(changed(full, "steps", List{Value(List{1, 2})})),
            Refusal(ErrorCode::type, "timing/0/steps/0"));
  EXPECT_EQ(timing_refusal(changed(full, "steps", List(TimingBlock::kMostSteps + 1, List{1}))),
            Refusal(ErrorCode::too_large, "timing/0/steps"));
  EXPECT_EQ(timing_refusal(changed(full, "since", 1)), Refusal(ErrorCode::type, "timing/0/since"));
  EXPECT_EQ(timing_refusal(changed(full, "more", 1)), Refusal(ErrorCode::unknown_field, "timing/0/more"));
  const Value start = Dict{{"input", Dict{{"kind", "abort"}}}, {"arrival", List{1, 1, 1}}, {"dropped", List{2, 0}}};
  EXPECT_EQ(timing_refusal(changed(full, "undelivered", List{start})),
            Refusal(ErrorCode::type, "timing/0/undelivered/0/input"));
  const Value named = Dict{{"time", 1}, {"service", std::string(201, 'x')}};
  EXPECT_EQ(timing_refusal(changed(full, "services", List{named})).first, ErrorCode::too_large);
}

class StoredTiming : public StoredRuns {
 protected:
  void SetUp() override { runs_->create(run_of(counting({})), 1).value(); }
  void write(const TimingBlock& block, RunId run = 1) const {
    SQLite::Database file(path(), SQLite::OPEN_READWRITE);
    Statements statements(file);
    write_timing(statements, run, timing_row(block));
  }
  std::vector<TimingBlock> read(std::uint64_t from = 0, const std::vector<TimingBlock>& recent = {}) const {
    std::vector<TimingBlock> blocks;
    const auto read = runs_->timing(1, from, recent, [&](const TimingBlock& block) {
      blocks.push_back(block);
      return true;
    });
    EXPECT_TRUE(read);
    return blocks;
  }

  const std::unique_ptr<Runs> runs_ = open();
};

TEST_F(StoredTiming, IsReadFromAMacroStepOnAndThenWhatIsNotStoredYet) {
  write(block(1, 3));
  write(block(4, 2));
  write(block(6, 0));
  EXPECT_EQ(read(), (std::vector{block(1, 3), block(4, 2), block(6, 0)}));
  EXPECT_EQ(read(4), (std::vector{block(4, 2), block(6, 0)}));
  TimingBlock recent = block(4, 2);
  EXPECT_EQ(read(1, {recent}), (std::vector{block(1, 3), recent})) << "what was stored meanwhile is there once";
}

TEST_F(StoredTiming, KeepsABoundedNumberOfBlocksTheNewest) {
  SQLite::Database file(path(), SQLite::OPEN_READWRITE);
  file.exec("BEGIN");
  Statements statements(file);
  for (std::uint64_t i = 1; i <= TimingBlock::kMostBlocks + 3; ++i)
    write_timing(statements, 1, timing_row(block(i, 1)));
  file.exec("COMMIT");
  const auto kept = read();
  ASSERT_EQ(kept.size(), TimingBlock::kMostBlocks);
  EXPECT_EQ(kept.front().first, 4U);
}

TEST_F(StoredTiming, CountsInTheSizeOfARunAndGoesWithIt) {
  ASSERT_TRUE(runs_->set_status(1, "aborted"));
  const std::uint64_t before = runs_->sizes()->at(0).second;
  write(full_block());
  EXPECT_EQ(runs_->sizes()->at(0).second, before + to_json(timing_json(full_block())).size());
  ASSERT_TRUE(runs_->remove(1));
  EXPECT_TRUE(read().empty());
}

TEST_F(StoredTiming, IsNamedIfItIsDamaged) {
  write(block(1, 3));
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("UPDATE timing SET last = 4");
  const auto read = runs_->timing(1, 0, {}, [](const TimingBlock&) { return true; });
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  EXPECT_EQ(read.error().path, "runs/1/timing/1");
}

TEST_F(StoredTiming, ComesWithAnImportedRun) {
  const execution::Journal journal = counting({1, 2});
  const auto imported = runs_->import({}, run_of(journal), journal.entries, {}, {full_block()});
  std::vector<TimingBlock> blocks;
  ASSERT_TRUE(runs_->timing(imported->id, 0, {}, [&](const TimingBlock& block) {
    blocks.push_back(block);
    return true;
  }));
  EXPECT_EQ(blocks, std::vector{full_block()});
}

TEST_F(StoredTiming, IsNotKnownOfRunsThatAnOlderVersionStored) {
  SQLite::Database(path(), SQLite::OPEN_READWRITE)
      .exec(
          "DROP TABLE timing; DROP TABLE picture; DROP TABLE picturing; DROP TABLE proposal; PRAGMA user_version = 8");
  const auto upgraded = open();
  EXPECT_EQ(upgraded->get(1)->document, "task");
  write(block(1, 1));
  EXPECT_EQ(read(), std::vector{block(1, 1)});
}

}  // namespace
}  // namespace race::server
