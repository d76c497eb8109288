// What leaves a core waits for its entry; a run is rebuilt from its journal, after the server ended and when the disk
// fails, and goes on when somebody says so.
#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "core/rcm/document.h"
#include "server/execution/cores.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"
#include "tests/unit/server/hosted_cores.h"

namespace race::server {
namespace {

struct Interruption : HostedCores {};

/// A disk that hangs is waited for so long: a sound one on a busy machine is never so slow.
constexpr auto kSlowDisk = std::chrono::milliseconds(1000);

TEST_F(Interruption, NothingLeavesACoreBeforeItsEntryIsDurable) {
  begin_server();
  const auto core = small_core();
  core->watch_state();
  const auto file = sqlite::open(folder.store());
  auto busy = std::make_unique<sqlite::WriteTransaction>(*file);  // the writer stands in line
  auto started = std::async(std::launch::async, [&] { return core->start(); });
  EXPECT_EQ(started.wait_for(std::chrono::milliseconds(300)), std::future_status::timeout) << "answered too early";
  EXPECT_EQ(observer.calls(), std::vector<std::string>{});
  EXPECT_EQ(all_told(), std::vector<std::string>{});
  EXPECT_EQ(status(core->info()), "ready");
  busy.reset();
  EXPECT_EQ(status(started.get()), "running");
  EXPECT_EQ(observer.calls(), (std::vector<std::string>{core->id() + ":go", core->id() + ":wait"}));
  EXPECT_EQ(runs->get(core->run_id())->steps, 1U);
}

TEST_F(Interruption, ARunIsRebuiltWhenTheServerBeginsAndWaitsForAPerson) {
  begin_server();
  const RunId id = [this] {
    const auto core = small_core();
    EXPECT_EQ(status(core->start()), "running");
    answer(*core, 2, 7);  // `wait` of A: B waits now
    wait(*core, [](const Value& info) { return info.find("step")->as_integer() == 2; });
    return core->run_id();
  }();
  const auto calls_before = observer.calls();
  end_server();
  begin_server();
  const auto core = cores->find(std::to_string(id)).value();
  const Value info = core->state().value().find("core")->as_dict();
  EXPECT_EQ(info.find("status")->as_string(), "interrupted");
  EXPECT_EQ(info.find("interruption")->find("reason")->as_string(), "restart");
  EXPECT_EQ(info.find("step")->as_integer(), 2);
  EXPECT_EQ(info.find("waiting")->as_integer(), 2) << "both open calls are lost";
  EXPECT_EQ(core->start().error().code, ErrorCode::conflict);
  EXPECT_EQ(observer.calls(), calls_before) << "nothing is called before somebody says so";
  EXPECT_EQ(status(core->resume()), "running");
  wait(*core, [](const Value& now) { return now.find("step")->as_integer() == 4; });
  const auto entries = runs->entries(id, 1, 4).value();
  const auto& lost = std::get<execution::ResponseEntry>(entries[2]);
  EXPECT_EQ(lost.call, 1U);
  EXPECT_TRUE(lost.is_error);
  EXPECT_EQ(lost.data, Value(Dict{{"code", "unavailable"}}));
  EXPECT_EQ(observer.calls(), calls_before) << "no call is sent again";
  EXPECT_EQ(status(core->stop()), "aborted");
  EXPECT_EQ(runs->get(id)->status, "aborted");
}

TEST_F(Interruption, ARunThatHadNotBegunIsReadyAgainAndOneThatIsOverIsNoCore) {
  begin_server();
  const RunId ready = small_core()->run_id();
  const auto over = small_core();
  ASSERT_TRUE(over->start());
  ASSERT_TRUE(over->stop());
  end_server();
  begin_server();
  ASSERT_EQ(cores->all().size(), 1U);
  EXPECT_EQ(cores->all().front()->run_id(), ready);
  EXPECT_EQ(status(cores->all().front()->start()), "running");
}

TEST_F(Interruption, AFailingDiskStopsTheRunAndWhatItHasSetInMotion) {
  begin_server();
  const auto core = small_core();
  ASSERT_TRUE(core->start());
  answer(*core, 2, 7);
  wait(*core, [](const Value& info) { return info.find("step")->as_integer() == 2; });
  const auto calls_before = observer.calls();
  disk.fail_at(1, sqlite::FaultyVfs::Fault::full, true);
  answer(*core, 3, 8);
  const Value info = wait(*core, [](const Value& now) { return now.find("status")->as_string() == "interrupted"; });
  EXPECT_EQ(info.find("interruption")->find("reason")->as_string(), "storage");
  EXPECT_EQ(info.find("step")->as_integer(), 2) << "what is not stored has not happened";
  auto calls = observer.calls();
  calls.erase(calls.begin(), calls.begin() + static_cast<std::ptrdiff_t>(calls_before.size()));
  EXPECT_EQ(calls, std::vector<std::string>{":stop"});
  EXPECT_EQ(core->resume().error().code, ErrorCode::storage);
  EXPECT_EQ(core->step({execution::Goal::Kind::macro}).error().code, ErrorCode::storage);
  EXPECT_EQ(core->stop().error().code, ErrorCode::storage);
  disk.repair();
  EXPECT_EQ(status(core->resume()), "running");
  wait(*core, [](const Value& now) { return now.find("step")->as_integer() == 4; });
  EXPECT_EQ(status(core->stop()), "aborted");
}

// Every operation of the disk waits until it is let go.
class HangingDisk {
 public:
  explicit HangingDisk(sqlite::FaultyVfs& disk) {
    disk.before_each([hangs = hangs_](std::uint64_t) { hangs->wait(true); });
  }
  ~HangingDisk() { let_go(); }
  void let_go() {
    *hangs_ = false;
    hangs_->notify_all();
  }

 private:
  // Of the disk, too: who waits looks at it when this has ended.
  const std::shared_ptr<std::atomic<bool>> hangs_ = std::make_shared<std::atomic<bool>>(true);
};

TEST_F(Interruption, ADiskThatHangsStopsTheRunAsOneThatFails) {
  disk_timeout = kSlowDisk;
  begin_server();
  const auto core = small_core();
  ASSERT_TRUE(core->start());
  answer(*core, 2, 7);
  wait(*core, [](const Value& info) { return info.find("step")->as_integer() == 2; });
  auto calls_before = observer.calls();
  HangingDisk hanging(disk);
  answer(*core, 3, 8);
  const Value info = wait(*core, [](const Value& now) { return now.find("status")->as_string() == "interrupted"; });
  EXPECT_EQ(info.find("interruption")->find("reason")->as_string(), "storage");
  EXPECT_EQ(info.find("step")->as_integer(), 2) << "whether the third is stored is not known yet";
  calls_before.push_back(":stop");
  EXPECT_EQ(observer.calls(), calls_before);
  EXPECT_EQ(core->resume().error().code, ErrorCode::storage);
  EXPECT_EQ(core->stop().error().code, ErrorCode::storage);
  EXPECT_EQ(core->pause().error().code, ErrorCode::storage);
  EXPECT_EQ(core->state().error().code, ErrorCode::storage);
  hanging.let_go();
  const Value after = wait(*core, [](const Value& now) { return now.find("step")->as_integer() == 3; });
  EXPECT_EQ(status(after), "interrupted") << "who was told that it stands still must not see it go on";
  EXPECT_EQ(observer.calls(), calls_before);
  EXPECT_EQ(status(core->resume()), "running");
  EXPECT_EQ(status(core->stop()), "aborted");
}

TEST_F(Interruption, WhatIsNotDurableIsNotShownWhenSomethingElseIsTold) {
  disk_timeout = kSlowDisk;
  begin_server();
  const auto core = small_core();
  ASSERT_TRUE(core->start());
  ASSERT_TRUE(core->set_live(true));
  HangingDisk hanging(disk);
  answer(*core, 2, 7);
  wait(*core, [](const Value& now) { return now.find("status")->as_string() == "interrupted"; });
  core->refuse_edit(7, {{ErrorCode::type, "of another service", "services/s"}});
  EXPECT_EQ(core->set_live(false).error().code, ErrorCode::storage);
  const Value info = core->info();
  EXPECT_EQ(info.find("status")->as_string(), "interrupted");
  EXPECT_EQ(info.find("step")->as_integer(), 1);
}

TEST_F(Interruption, AStartThatADiskHoldsUpIsRefusedAndCommandsNothingLater) {
  disk_timeout = kSlowDisk;
  begin_server();
  const auto core = small_core();
  {
    HangingDisk hanging(disk);
    EXPECT_EQ(core->start().error().code, ErrorCode::storage);
  }
  wait(*core, [](const Value& now) { return now.find("step")->as_integer() == 1; });
  EXPECT_EQ(status(core->info()), "interrupted");
  EXPECT_EQ(observer.calls(), std::vector<std::string>{":stop"});
}

TEST_F(Interruption, AnEndThatADiskHeldUpIsTheEnd) {
  disk_timeout = kSlowDisk;
  begin_server();
  const auto core = small_core();
  ASSERT_TRUE(core->start());
  {
    HangingDisk hanging(disk);
    EXPECT_EQ(core->stop().error().code, ErrorCode::storage);
    EXPECT_EQ(status(core->info()), "interrupted");
  }
  wait(*core, [](const Value& now) { return now.find("status")->as_string() == "aborted"; });
}

TEST_F(Interruption, AStartThatCannotBeStoredHasNotHappened) {
  begin_server();
  const auto core = small_core();
  disk.fail_at(1, sqlite::FaultyVfs::Fault::io, true);
  EXPECT_EQ(core->start().error().code, ErrorCode::storage);
  disk.repair();
  wait(*core, [](const Value& now) { return now.find("status")->as_string() == "ready"; });
  const auto started = core->start();
  ASSERT_TRUE(started) << started.error().message;
  EXPECT_EQ(status(started), "running");
}

// The entry of the last macro step is durable, the record that it is the last is not.
TEST_F(Interruption, ARunWhoseEndCannotBeStoredIsInterruptedOnceAndEndsWhenTheDiskWorks) {
  begin_server();
  const auto core = small_core();
  ASSERT_TRUE(core->start());
  disk.fail_at(1, sqlite::FaultyVfs::Fault::full, true);
  EXPECT_EQ(core->stop().error().code, ErrorCode::storage);
  wait(*core, [](const Value& now) { return now.find("status")->as_string() == "interrupted"; });
  const auto calls = observer.calls();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(observer.calls(), calls) << "it is not interrupted again and again";
  disk.repair();
  EXPECT_EQ(status(core->stop()), "aborted");
  EXPECT_EQ(runs->get(core->run_id())->status, "aborted");
}

TEST_F(Interruption, ARunWithoutTheRecordOfItsEndIsOverWhenTheServerBegins) {
  begin_server();
  const auto core = small_core();
  const RunId id = core->run_id();
  ASSERT_TRUE(core->start());
  ASSERT_TRUE(core->stop());
  end_server();
  runs = Runs::open(folder.store()).value();
  ASSERT_TRUE(runs->set_status(id, "running"));
  begin_server();
  const auto again = cores->find(std::to_string(id)).value();
  wait(*again, [](const Value& now) { return now.find("status")->as_string() == "aborted"; });
  EXPECT_EQ(runs->get(id)->status, "aborted");
}

// Neither written nor read: what is in memory is in no journal.
TEST_F(Interruption, WhatCannotBeReadBackIsNotShown) {
  begin_server();
  const auto core = small_core();
  ASSERT_TRUE(core->start());
  disk.fail_at(1, sqlite::FaultyVfs::Fault::io, true);
  EXPECT_EQ(core->stop().error().code, ErrorCode::storage);
  const Value info = wait(*core, [](const Value& now) { return now.find("status")->as_string() == "interrupted"; });
  EXPECT_EQ(info.find("step")->as_integer(), 1) << "the abort is not stored";
  EXPECT_EQ(info.find("results"), nullptr);
  disk.repair();
  EXPECT_EQ(status(core->resume()), "running") << "the run is not over";
  EXPECT_EQ(status(core->stop()), "aborted");
}

TEST_F(Interruption, ACoreIsNotRemovedBeforeItsEndIsStored) {
  begin_server();
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  const auto core = cores->create({"r", 1, document}, {}).value();
  ASSERT_TRUE(core->start());
  disk.fail_at(1, sqlite::FaultyVfs::Fault::full, true);
  EXPECT_EQ(cores->remove(core->id()).error().code, ErrorCode::storage);
  EXPECT_TRUE(cores->find(core->id()));
  disk.repair();
  EXPECT_TRUE(cores->remove(core->id()));
  EXPECT_EQ(runs->get(core->run_id())->status, "aborted");
}

TEST_F(Interruption, NothingBeginsWhileTheStoreBecomesAnother) {
  begin_server();
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  const auto ready = cores->create({"r", 1, document}, {}).value();
  ASSERT_TRUE(cores->close_for_restore());
  EXPECT_EQ(ready->start().error().code, ErrorCode::conflict);
  EXPECT_EQ(cores->create({"r", 1, document}, {}).error().front().code, ErrorCode::conflict);
  EXPECT_EQ(cores->load(ready->id(), {"r", 1, document}, {}).error().front().code, ErrorCode::conflict);
  cores->reopen();
  ASSERT_TRUE(ready->start());
  EXPECT_EQ(cores->close_for_restore().error().code, ErrorCode::conflict) << "a run goes on";
  EXPECT_TRUE(cores->create({"r", 1, document}, {}));
}

}  // namespace
}  // namespace race::server
