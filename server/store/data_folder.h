// DataFolder: the folder in which a server keeps all that it keeps, held by one server at a time:
//
//   race.sqlite      documents with their revisions, runs with their journals (schema.h)
//   database.sqlite  values of the service `db` (services/database), unless its process has a file of its own
//   accounts.sqlite  accounts and tokens (server/accounts); not in backups
//   audit.sqlite     who has changed what (server/accounts); not in backups
//   processes.token  the token of processes of services (server/accounts/local_key.h)
//   stopped          the cell was stopped, and by whom (server/control/stop_mark.h)
//   mode             the mode of the cell (server/control/mode_mark.h)
//   backups/         one folder each (backup.h)
//   lock             held while a server runs
//
// Threads: any.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/value/expected.h"

namespace race::server {

class DataFolder {
 public:
  /// Makes the folder if it is not there, takes it, and brings its store to this version: documents of an older one are
  /// taken over. One of an older version is first copied as a backup, and changed in one transaction; one of a newer
  /// version is left as it is. Errors: `conflict` (another server holds it, or there is no room for another backup),
  /// `corrupt`, `version` (a newer one), `storage`, `io`, with the path.
  static Expected<DataFolder> open(const std::string& path);
  /// Makes and takes the folder, whatever its files are: to restore a backup. Errors: `conflict`, `storage`.
  static Expected<DataFolder> take(const std::string& path);
  DataFolder(DataFolder&& other) noexcept;
  DataFolder& operator=(DataFolder&&) = delete;
  ~DataFolder();

  const std::filesystem::path& path() const { return path_; }
  /// The name of the backup of the store as an older version of the program left it, if open() has changed it.
  const std::optional<std::string>& copy_before_upgrade() const { return copy_before_upgrade_; }
  std::string store() const { return path_ / "race.sqlite"; }
  std::string database() const { return path_ / "database.sqlite"; }
  std::string accounts() const { return path_ / "accounts.sqlite"; }
  std::string audit() const { return path_ / "audit.sqlite"; }
  std::string stop_mark() const { return path_ / "stopped"; }
  std::string mode_mark() const { return path_ / "mode"; }
  std::string process_token() const { return path_ / "processes.token"; }

 private:
  DataFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}
  std::filesystem::path path_;
  int lock_;  // file descriptor
  std::optional<std::string> copy_before_upgrade_;
};

}  // namespace race::server
