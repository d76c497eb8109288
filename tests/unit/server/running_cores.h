// Cores that run on a store of their own, for tests of what is kept beside runs. With a disk that fails:
// hosted_cores.h.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

#include "core/rcm/document.h"
#include "server/execution/cores.h"
#include "tests/unit/server/run_store.h"

namespace race::server {

struct RunningCores : testing::Test, CoreWatcher {
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

  services::WorldClock clock;
  NoObserver observer;
  services::Host host{clock, observer};
  std::unique_ptr<Pool> pool = std::make_unique<Pool>(1);
  TemporaryStore store;
  Deadlines deadlines;
  Worker replays{deadlines};
  Cores cores{*pool, host, *this, *store.runs, *store.writer, replays, deadlines};
};

}  // namespace race::server
