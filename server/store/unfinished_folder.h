// UnfinishedFolder: a folder in which a process makes something that then gets its name at once. It is locked
// meanwhile, so that what a crash has left can be told from what another process is making.
//
// Threads: one at a time.
#pragma once

#include <filesystem>
#include <string>

#include "core/value/expected.h"

namespace race::server {

class UnfinishedFolder {
 public:
  /// A new folder beside `whole`, which it is to become. Requires an absolute path. Error `storage`.
  static Expected<UnfinishedFolder> create(const std::filesystem::path& whole);
  UnfinishedFolder(UnfinishedFolder&& other) noexcept;
  UnfinishedFolder& operator=(UnfinishedFolder&&) = delete;
  /// Removes it, unless it was finished.
  ~UnfinishedFolder();

  const std::filesystem::path& path() const { return path_; }
  /// Gives it its name, durably. Errors: `conflict` (there is something of this name), `storage`.
  Expected<void> finish();

  /// Renames a folder to one that remove_abandoned() removes. Its new path. Throws std::filesystem::filesystem_error.
  static std::filesystem::path abandon(const std::filesystem::path& folder);
  /// Removes what a crash has left in `folder`, of this version or an older one: unfinished folders that no process
  /// holds, those that were to become `name` or any (empty).
  static void remove_abandoned(const std::filesystem::path& folder, const std::string& name = "");

 private:
  UnfinishedFolder(std::filesystem::path whole, std::filesystem::path path, int lock);
  std::filesystem::path whole_, path_;
  int lock_;  // file descriptor
};

}  // namespace race::server
