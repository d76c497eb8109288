#include "server/queue/run_queue.h"

#include <gmock/gmock.h>

#include <atomic>
#include <functional>
#include <new>

#include "tests/unit/server/running_cores.h"

namespace race::server {
namespace {

using testing::ElementsAre;

// Everybody stays who they are until a test says otherwise.
struct Records final : ClientRecords {
  bool is_current(const Identity&) const override {
    when_asked();
    return current;
  }
  void record(const Identity& identity, std::string action, std::string outcome) override {
    const services::MutexLock lock(mutex);
    rows.push_back(identity.account + ": " + action + ": " + outcome);
  }
  void refused(const Identity&, const Error&) override {}
  std::vector<std::string> all() EXCLUDES(mutex) {
    const services::MutexLock lock(mutex);
    return rows;
  }
  std::atomic<bool> current{true};
  std::function<void()> when_asked = [] {};  // on the thread of the queue, before a core is made; set while it rests
  services::Mutex mutex;
  std::vector<std::string> rows GUARDED_BY(mutex);
};

struct RunQueueTest : RunningCores {
  void SetUp() override {
    put("waits", R"({"state": "R"})");
    put("ends", R"({"state": "R", "ports": [{"name": "done", "when": "True"}]})");
    put("faults", R"({"state": "R", "variables": [{"name": "x", "initial": 0}], "entry": "var.x = 1 / var.x"})");
  }
  void TearDown() override {
    queue.end();
    RunningCores::TearDown();
  }
  void core_changed(const std::string& id, Value core) override {
    if (tells) queue.core_changed(id, core);
  }
  void core_removed(const std::string& id) override {
    queue.core_changed(id, Value());
    ++removals;
  }

  void put(const std::string& name, const std::string& root) {
    ASSERT_TRUE(documents->put(name, R"({"rcm": 1, "name": ")" + name + R"(", "root": )" + root + "}"));
  }
  static QueuedTask task(const std::string& document) {
    QueuedTask task;
    task.document = document;
    task.by.account = "planner";
    return task;
  }
  std::string add(const std::string& document) { return std::to_string(queue.add(task(document)).value().id); }
  std::string add_that_goes_on(const std::string& document) {
    QueuedTask made = task(document);
    made.goes_on = true;
    return std::to_string(queue.add(std::move(made)).value().id);
  }
  // Of each run that is kept: "document status", and how it ended.
  std::vector<std::string> runs() {
    std::vector<std::string> out;
    const Value json = queue.json(0, 1000);
    for (const Value& run : json.find("runs")->as_list()) {
      std::string text = run.find("document")->as_string() + ' ' + run.find("status")->as_string();
      for (const char* key : {"end", "outcome"})
        if (const Value* value = run.find(key)) text += ' ' + value->as_string();
      if (const Value* errors = run.find("errors")) text += ' ' + errors->as_list().front().find("code")->as_string();
      out.push_back(std::move(text));
    }
    return out;
  }
  // Why it pauses, and after which run; empty: it does not.
  std::string paused() {
    const Value json = queue.json(0, 1);
    const Value* pause = json.find("paused");
    if (!pause) return "";
    const Value* run = pause->find("run");
    return pause->find("reason")->as_string() + (run ? ' ' + run->as_string() : "");
  }
  static void until(const std::function<bool()>& condition) {
    while (!condition()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  // The core of a run that runs.
  std::shared_ptr<Core> core_of(const std::string& id) {
    std::shared_ptr<Core> core;
    until([&] {
      const auto found = cores.find(queue.find(id).value().core);
      if (found) core = *found;
      return core && core->info().find("status")->as_string() == "running";
    });
    return core;
  }

  std::atomic<int> removals{0};
  std::atomic<bool> tells{true};  // the queue of changes, but for removals
  std::unique_ptr<Documents> documents = Documents::open(store.folder.store()).value();
  Control control{[](const Value&) {}};
  Records records;
  RunQueue queue{control, *documents, cores, records};
};

TEST_F(RunQueueTest, OneBeginsWhenTheOneBeforeItIsOver) {
  for (int i = 0; i < 3; ++i) add("ends");
  const std::string last = add("waits");
  const auto core = core_of(last);
  const std::string done = "ends ended ended done";
  EXPECT_THAT(runs(), ElementsAre(done, done, done, "waits running"));
  EXPECT_EQ(core->id(), "4") << "in their order";
  add("ends");
  queue.end();  // what would have begun has
  EXPECT_EQ(runs().back(), "ends waiting");
}

TEST_F(RunQueueTest, AnAbortPausesItInAnyCase) {
  const std::string first = add_that_goes_on("waits");
  add("ends");
  EXPECT_TRUE(core_of(first)->stop());
  until([&] { return !paused().empty(); });
  EXPECT_EQ(paused(), "aborted " + first);
  EXPECT_THAT(runs(), ElementsAre("waits ended aborted", "ends waiting"));
  EXPECT_TRUE(queue.resume());
  until([&] { return runs().back() == "ends ended ended done"; });
  EXPECT_EQ(paused(), "");
}

TEST_F(RunQueueTest, AFaultPausesItUnlessTheRunSaysOtherwise) {
  add_that_goes_on("faults");
  const std::string second = add("faults");
  add("ends");
  until([&] { return !paused().empty(); });
  EXPECT_EQ(paused(), "faulted " + second);
  EXPECT_THAT(runs(), ElementsAre("faults ended faulted", "faults ended faulted", "ends waiting"));
}

TEST_F(RunQueueTest, ACoreThatIsRemovedIsAnAbort) {
  const std::string first = add("waits");
  add("ends");
  ASSERT_TRUE(cores.remove(core_of(first)->id()));
  until([&] { return !paused().empty(); });
  EXPECT_THAT(runs(), ElementsAre("waits ended aborted", "ends waiting"));
}

TEST_F(RunQueueTest, ACoreThatIsRemovedBeforeItsEndIsToldHasEndedAsItHas) {
  const std::string first = add("waits");
  const auto core = core_of(first);
  tells = false;
  EXPECT_TRUE(core->stop());
  EXPECT_EQ(runs().front(), "waits running");
  const std::string second = add("ends");
  ASSERT_TRUE(cores.remove(core->id()));
  EXPECT_EQ(paused(), "aborted " + first);
  EXPECT_TRUE(queue.resume());
  std::shared_ptr<Core> ended;
  until([&] {
    const auto found = cores.find(queue.find(second).value().core);
    if (found) ended = *found;
    return ended && is_over(ended->info());
  });
  ASSERT_TRUE(cores.remove(ended->id()));
  EXPECT_EQ(runs().back(), "ends ended ended done");
  EXPECT_EQ(paused(), "");
}

TEST_F(RunQueueTest, APausedRunKeepsItsPlace) {
  const auto core = core_of(add("waits"));
  add("ends");
  EXPECT_TRUE(core->pause());
  queue.end();
  EXPECT_THAT(runs(), ElementsAre("waits running", "ends waiting"));
}

TEST_F(RunQueueTest, NothingBeginsWhileTheCellIsStoppedNorByItsReset) {
  control.stop({"somebody", 0});
  add("ends");
  until([&] { return !paused().empty(); });
  EXPECT_EQ(paused(), "stopped");
  EXPECT_EQ(queue.resume().error().code, ErrorCode::stopped);
  control.reset();
  queue.add(task("ends")).value();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_THAT(runs(), ElementsAre("ends waiting", "ends waiting"));
  EXPECT_TRUE(queue.resume());
  until([&] { return runs().back() == "ends ended ended done"; });
}

TEST_F(RunQueueTest, AStopOfBeforeHoldsUpNothing) {
  control.stop({"somebody", 0});
  control.reset();
  add("ends");
  until([&] { return runs().back() == "ends ended ended done"; });
}

TEST_F(RunQueueTest, AStopThatIsResetWhileItsRunEndsWellPausesWhatWaits) {
  tells = false;
  const std::string first = add("ends");
  std::shared_ptr<Core> core;
  until([&] {
    const auto found = cores.find(queue.find(first).value().core);
    if (found) core = *found;
    return core && core->info().find("status")->as_string() == "ended";
  });
  add("waits");
  control.stop({"somebody", 0});
  control.reset();
  queue.core_changed(core->id(), core->info());
  until([&] { return !paused().empty(); });
  EXPECT_EQ(paused(), "stopped");
  EXPECT_THAT(runs(), ElementsAre("ends ended ended done", "waits waiting"));
}

TEST_F(RunQueueTest, WhatIsStoppedWhileItsCoreIsMadeNeverBegins) {
  records.when_asked = [&] {
    control.stop({"somebody", 0});
    control.reset();
  };
  const std::string stopped = add("ends");
  until([&] { return !paused().empty(); });
  EXPECT_EQ(queue.find(stopped)->errors.front().code, ErrorCode::stopped);
  EXPECT_THAT(runs(), ElementsAre("ends refused stopped"));
  until([&] { return removals == 1; });  // its core goes
}

TEST_F(RunQueueTest, WhoIsNotKnownAnyMoreBeginsNothing) {
  const std::string first = add("waits");
  const auto core = core_of(first);
  const std::string second = add("ends");
  add("ends");
  records.current = false;
  EXPECT_TRUE(core->stop());
  until([&] { return !paused().empty(); });
  EXPECT_TRUE(queue.resume());
  until([&] { return paused() == "refused " + second; });
  EXPECT_THAT(runs(), ElementsAre("waits ended aborted", "ends refused rights", "ends waiting"));
  EXPECT_THAT(records.all(), ElementsAre("planner: queue start 1: core 1", "planner: queue start 2: rights"));
}

TEST_F(RunQueueTest, WhoHadTheControlsMustHaveThemStill) {
  const std::uint64_t number = control.take("ada", std::chrono::steady_clock::now()).value();
  QueuedTask theirs = task("ends");
  theirs.control = number;
  queue.add(theirs).value();
  until([&] { return runs().front() == "ends ended ended done"; });
  control.release(number);
  queue.add(theirs).value();
  until([&] { return !paused().empty(); });
  EXPECT_THAT(runs(), ElementsAre("ends ended ended done", "ends refused leased"));
}

TEST_F(RunQueueTest, TheRevisionIsThatOfThen) {
  const auto core = core_of(add("waits"));
  const std::string second = add("ends");
  put("ends", R"({"state": "R", "ports": [{"name": "other", "when": "True"}]})");
  EXPECT_TRUE(core->stop());
  until([&] { return !paused().empty(); });
  EXPECT_TRUE(queue.resume());
  until([&] { return queue.find(second).value().status == QueuedStatus::ended; });
  EXPECT_EQ(queue.find(second).value().outcome, "done");
}

TEST_F(RunQueueTest, WhatIsOfAStoreThatIsNoMoreNeverBegins) {
  const std::string first = add("waits");
  const auto core = core_of(first);
  add("ends");
  QueuedTask early = task("ends");
  early.restores = queue.restores();
  queue.cancel_all();  // as a restore does
  EXPECT_EQ(queue.add(early).error().code, ErrorCode::conflict);
  EXPECT_THAT(runs(), ElementsAre("waits running", "ends cancelled"));
  early.restores = queue.restores();
  EXPECT_TRUE(queue.add(early));
  EXPECT_TRUE(core->stop());
  until([&] { return !paused().empty(); });
  EXPECT_TRUE(queue.resume());
  until([&] { return runs().back() == "ends ended ended done"; });
}

TEST_F(RunQueueTest, WhatIsBeingBegunWhenTheStoreBecomesAnotherIsRefusedAndLeavesNoCore) {
  records.when_asked = [this] { queue.cancel_all(); };
  const std::string first = add("ends");
  until([&] { return !paused().empty(); });
  EXPECT_EQ(paused(), "refused " + first);
  EXPECT_THAT(runs(), ElementsAre("ends refused conflict"));
  until([&] { return cores.all().empty(); });
}

TEST_F(RunQueueTest, OneThatCannotBeBegunKeepsNobodyFromTheirTurn) {
  records.when_asked = [] { throw std::bad_alloc(); };
  add("ends");
  until([&] { return !paused().empty(); });
  EXPECT_THAT(runs(), ElementsAre("ends refused unavailable"));
  records.when_asked = [] {};
  add("ends");
  EXPECT_TRUE(queue.resume());
  until([&] { return runs().back() == "ends ended ended done"; });
}

TEST_F(RunQueueTest, OneThatWaitsIsCancelled) {
  const std::string first = add("waits"), second = add("ends");
  core_of(first);
  EXPECT_EQ(queue.cancel(first).error().code, ErrorCode::conflict);
  EXPECT_EQ(queue.cancel("7").error().code, ErrorCode::not_found);
  EXPECT_EQ(queue.cancel(second).value().status, QueuedStatus::cancelled);
  EXPECT_EQ(queue.cancel(second).error().code, ErrorCode::conflict);
  add("ends");
  queue.cancel_all();
  EXPECT_THAT(runs(), ElementsAre("waits running", "ends cancelled", "ends cancelled"));
}

TEST_F(RunQueueTest, IsBounded) {
  core_of(add("waits"));
  for (std::size_t i = 0; i < RunQueue::kMostWaiting; ++i) add("ends");
  EXPECT_EQ(queue.add(task("ends")).error().code, ErrorCode::conflict);
  for (std::size_t i = 0; i < RunQueue::kMostOver + 5; ++i) {
    const std::string waits = std::to_string(i + 2);
    EXPECT_TRUE(queue.cancel(waits));
    add("ends");
  }
  const Value json = queue.json(0, 1000);
  EXPECT_EQ(json.find("runs")->as_list().size(), 1 + RunQueue::kMostWaiting + RunQueue::kMostOver);
  EXPECT_EQ(json.find("waiting")->as_integer(), static_cast<std::int64_t>(RunQueue::kMostWaiting));
  QueuedTask large = task("ends");
  large.arguments = Dict{{"x", std::string(RunQueue::kMostArgumentUnits, 'x')}};
  EXPECT_EQ(queue.add(large).error().code, ErrorCode::too_large);
}

TEST_F(RunQueueTest, ComesInPages) {
  core_of(add("waits"));
  for (int i = 0; i < 4; ++i) add("ends");
  const Value first = queue.json(0, 2), rest = queue.json(2, 3);
  EXPECT_EQ(first.find("next")->as_integer(), 2);
  EXPECT_EQ(rest.find("runs")->as_list().front().find("id")->as_string(), "3");
  EXPECT_EQ(rest.find("next"), nullptr);
}

}  // namespace
}  // namespace race::server
