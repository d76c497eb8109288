// RunKeeper: samples of runs that go on, and the limits of the store.
#include "server/runs/run_keeper.h"

#include <SQLiteCpp/Database.h>

#include <chrono>
#include <thread>

#include "core/rcm/document.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"
#include "tests/unit/server/run_store.h"

namespace race::server {
namespace {

struct RunKeeperTest : testing::Test, CoreWatcher {
  // Not by the destructor: threads call this watcher until then.
  void TearDown() override {
    cores.close();
    store.writer->close();
    pool.reset();
  }
  void core_changed(const std::string&, Value) override {}
  void core_removed(const std::string&) override {}
  void state_replaced(const std::string&, Value) override {}
  void state_snapshot(const std::string&, Value) override {}
  void state_changed(const std::string&, Value) override {}
  void derivation_snapshot(const std::string&, Value) override {}
  void derived(const std::string&, Value) override {}
  void printed(const std::string&, const std::string&) override {}
  void run_lost(const std::string&, const std::string&) override {}

  /// A core that is running and waits.
  std::shared_ptr<Core> running_core() {
    const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
    auto core = cores.create({"r", 1, document}, {}).value();
    EXPECT_TRUE(core->start());
    while (core->info().find("status")->as_string() != "running")
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return core;
  }
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

  services::WorldClock clock;
  NoObserver observer;
  services::Host host{clock, observer};
  std::unique_ptr<Pool> pool = std::make_unique<Pool>(1);
  TemporaryStore store;
  std::unique_ptr<Samples> samples = Samples::open(store.folder.store()).value();
  Deadlines deadlines;
  Worker replays{deadlines};
  Cores cores{*pool, host, *this, *store.runs, *store.writer, replays, deadlines};
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
