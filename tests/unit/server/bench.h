// What tests of the server share: a Host whose news nobody wants, folders that are removed at the end, a store.
#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

#include "server/store/data_folder.h"
#include "server/store/journal_writer.h"
#include "server/store/runs.h"
#include "server/stream/requests.h"
#include "services/host/host.h"

namespace race::server {

struct NoObserver final : services::HostObserver {
  void delivered(const services::Delivery&) override {}
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string&) override {}
};

struct NoEdits final : EditRequests {
  void request_edit(const std::shared_ptr<Subscriber>&, const Value&) override {}
};

/// A new data folder, removed at the end.
struct TemporaryFolder {
  TemporaryFolder() {
    static std::atomic<int> next{0};
    path = memory() / ("race_test_" + std::to_string(::getpid()) + "_" + std::to_string(++next));
    std::filesystem::create_directories(path);
  }
  /// Most tests store nothing that has to outlive them.
  static std::filesystem::path memory() {
    return std::filesystem::exists("/dev/shm") ? "/dev/shm" : std::filesystem::temp_directory_path();
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path path;
};

/// The store of runs in a folder of its own.
struct TemporaryStore {
  TemporaryFolder place;
  DataFolder folder = DataFolder::open(place.path).value();
  std::unique_ptr<Runs> runs = Runs::open(folder.store()).value();
  std::unique_ptr<JournalWriter> writer = JournalWriter::open(folder.store()).value();
};

}  // namespace race::server
