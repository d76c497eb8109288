// Cores on a data folder and a disk that can fail; what they tell and call.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "server/execution/cores.h"
#include "server/store/data_folder.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/server/bench.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"

namespace race::server {

// Calls that reached the host: nobody offers a service, so each is answered at once.
struct CallObserver final : services::HostObserver {
  void delivered(const services::Delivery& delivery) override {
    const services::MutexLock lock(mutex);
    names.push_back(delivery.caller.core + ":" + delivery.name);
  }
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string&) override {}
  std::vector<std::string> calls() {
    const services::MutexLock lock(mutex);
    return names;
  }
  services::Mutex mutex;
  std::vector<std::string> names GUARDED_BY(mutex);
};

struct HostedCores : testing::Test, CoreWatcher {
  // Not by the destructor: threads of the server call this watcher until then.
  void TearDown() override { end_server(); }

  // A server on the same data folder as the one before.
  void begin_server() {
    runs = Runs::open(folder.store()).value();
    writer = JournalWriter::open(folder.store(), disk_timeout).value();
    pool = std::make_unique<Pool>(2);
    cores = std::make_unique<Cores>(*pool, host, *this, *runs, *writer, replays, deadlines);
    ASSERT_TRUE(cores->recover());
  }
  void end_server() {
    if (cores) cores->close();
    if (writer) writer->close();
    pool.reset();
    cores.reset();
    writer.reset();
    runs.reset();
  }
  // A core of the task that calls `go` and `wait` when it starts, and waits for their responses.
  std::shared_ptr<Core> small_core() {
    const execution::JournalHeader header = execution::small_journal().header;
    RunRecord run = runs->create({"small", 1, header, {}}, 0).value();
    return Core::create(std::move(run), header, {*pool, host, *this, *runs, *writer, replays, deadlines, watchdog})
        .value();
  }
  static void answer(Core& core, std::uint64_t call, const Value& data) {
    services::Delivery delivery;
    delivery.kind = services::Delivery::Kind::response;
    delivery.caller = {core.id(), call};
    delivery.data = data;
    delivery.data.freeze();
    delivery.units = delivery.data.size_units();
    core.deliver(delivery);
  }
  static std::string status(const Expected<Value>& info) { return info.value().find("status")->as_string(); }
  static Value wait(Core& core, const std::function<bool(const Value&)>& condition) {
    while (!condition(core.info())) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return core.info();
  }

  void core_changed(const std::string&, Value json) override {
    const services::MutexLock lock(mutex);
    told.push_back(json.find("status")->as_string());
  }
  void core_removed(const std::string&) override {}
  void state_replaced(const std::string&, Value) override {}
  void state_snapshot(const std::string&, Value) override {}
  void state_changed(const std::string&, Value) override {
    const services::MutexLock lock(mutex);
    told.emplace_back("delta");
  }
  void derivation_snapshot(const std::string&, Value) override {}
  void derived(const std::string&, Value) override {}
  void run_lost(const std::string&, const std::string&) override {}
  void printed(const std::string&, const std::string& text) override {
    const services::MutexLock lock(mutex);
    told.push_back(text);
  }
  std::vector<std::string> all_told() {
    const services::MutexLock lock(mutex);
    return told;
  }

  services::Mutex mutex;
  std::vector<std::string> told GUARDED_BY(mutex);
  services::WorldClock clock;
  CallObserver observer;
  services::Host host{clock, observer};
  sqlite::FaultyVfs disk;
  TemporaryFolder place;
  DataFolder folder = DataFolder::open(place.path).value();
  std::chrono::milliseconds disk_timeout = DiskWatch::kTimeout;
  std::unique_ptr<Runs> runs;
  std::unique_ptr<JournalWriter> writer;
  std::unique_ptr<Pool> pool;
  Deadlines deadlines;
  Worker replays{deadlines};
  Watchdog watchdog;
  std::unique_ptr<Cores> cores;
};

}  // namespace race::server
