// TemporaryFolder: a folder for the files of one test, removed with all that is in it.
#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>

namespace race {

/// A new, empty folder; programs that run side by side have different ones. In memory if the system has such a place,
/// as most tests store nothing that has to outlive them.
struct TemporaryFolder {
  TemporaryFolder() {
    static std::atomic<int> next{0};
    path = memory() / ("race_test_" + std::to_string(::getpid()) + "_" + std::to_string(++next));
    std::filesystem::create_directories(path);
  }
  static std::filesystem::path memory() {
    return std::filesystem::canonical(std::filesystem::exists("/dev/shm") ? "/dev/shm"
                                                                          : std::filesystem::temp_directory_path());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return path / name; }

  std::filesystem::path path;
};

}  // namespace race
