// RunKeeper: samples of runs that go on, and the limits of the store.
#include "server/runs/run_keeper.h"

#include <SQLiteCpp/Database.h>

#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"
#include "tests/unit/server/running_cores.h"

namespace race::server {
namespace {

struct RunKeeperTest : RunningCores {
  static Value pose(double time) {
    Value pose = Dict{{"time", time}};
    return pose.freeze();
  }
  void import() {
    const execution::Journal journal = counting({1});
    RunRecord record;
    record.status = "ended";
    ASSERT_TRUE(store.runs->import(record, {"task", 1, journal.header, {}}, journal.entries));
  }

  std::unique_ptr<Samples> samples = Samples::open(store.folder.store()).value();
};

TEST_F(RunKeeperTest, FlushWritesTheSamplesThatWait) {
  RunKeeper keeper{*store.runs, *samples, {}, [](LogLevel, const std::string& text) { ADD_FAILURE() << text; }};
  keeper.connect(cores, nullptr);
  const RunId run = running_core()->run_id();
  for (int i = 0; i < 3; ++i) keeper.record(pose(i));
  keeper.flush();
  EXPECT_EQ(samples->read(run)->size(), 3U);
}

TEST_F(RunKeeperTest, KeepsABoundedNumberOfPosesWhileTheDiskTakesNone) {
  RunKeeper keeper{*store.runs, *samples, {}, [](LogLevel, const std::string& text) { ADD_FAILURE() << text; }};
  keeper.connect(cores, nullptr);
  const RunId run = running_core()->run_id();
  const auto file = sqlite::open(store.folder.store());
  auto busy = std::make_unique<sqlite::WriteTransaction>(*file);
  for (int i = 0; i < 1000; ++i) keeper.record(pose(i));
  busy.reset();
  keeper.flush();
  const std::size_t most = RunKeeper::kMostWaiting + RunKeeper::kWritten;
  EXPECT_LE(samples->read(run)->size(), most);
  EXPECT_GE(samples->read(run)->size(), RunKeeper::kMostWaiting);
}

TEST_F(RunKeeperTest, AnImportBringsTheStoreWithinItsLimits) {
  std::vector<std::string> logged;
  RunKeeper limited{
      *store.runs, *samples, {.runs = 2}, [&](LogLevel, const std::string& text) { logged.push_back(text); }};
  limited.connect(cores, nullptr);
  for (int i = 0; i < 3; ++i) import();
  limited.flush();
  EXPECT_EQ(logged, std::vector<std::string>{"removed the oldest runs: 1"});
  const auto left = store.runs->list(0, 10).value();
  ASSERT_EQ(left.runs.size(), 2U);
  EXPECT_EQ(left.runs.back().id, 2U);
}

}  // namespace
}  // namespace race::server
