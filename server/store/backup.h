// Backups: copies of all that the server keeps, made and brought back while it runs. Each is a folder below `backups`
// of the data folder, named by its time (UTC):
//
//   20261122T143104.123Z/race.sqlite, database.sqlite   copies by SQLite's online backup; each of one moment
//   20261122T143104.123Z/digests.json                   the SHA-256 of each: a damaged backup is never brought back
//
// A backup appears whole or not at all: it is written beside, synchronised and renamed. race.sqlite is copied first:
// values of the database may be newer than the journals of runs that go on meanwhile.
//
// Threads: any. One at a time makes, removes or brings back; list() waits for none of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/mutex.h"

namespace race::server {

struct Backup {
  std::string name;
  std::int64_t created_ms = 0;  // since 1970
  std::uint64_t bytes = 0;
};

class Backups {
 public:
  static constexpr std::size_t kMost = 20;

  /// Of the data folder `data`. What a crash has left of a backup is removed. `restored` is called when the files have
  /// become others: who keeps something of them reads it again; its error is that of restore().
  explicit Backups(
      std::filesystem::path data, std::function<Expected<void>()> restored = [] { return Expected<void>(); });

  // Errors of all: `storage`, `io`, `corrupt`.

  /// Copies everything as it is now. Error `conflict`: there are kMost already, or one of this millisecond.
  Expected<Backup> create(std::int64_t now_ms) EXCLUDES(mutex_);
  /// Those that are whole, in order of time; also while one is being made.
  Expected<std::vector<Backup>> list() const;
  /// `not_found`
  Expected<Backup> remove(const std::string& name) EXCLUDES(mutex_);
  /// Makes the files what they were, and each in one transaction: who has them open sees the old content or the new.
  /// Requires that no run goes on. `begin` is called before anything is changed, when the backup is known to be sound;
  /// its error ends it. Errors, with nothing changed: `not_found`; `corrupt` (the backup is damaged); `version` (a
  /// newer version of the program made it). If the disk fails between the two files, one is restored: restore again.
  Expected<Backup> restore(const std::string& name, const std::function<Expected<void>()>& begin) EXCLUDES(mutex_);

 private:
  Expected<Backup> find(const std::string& name) const;
  std::vector<Backup> all() const;

  const std::filesystem::path data_, folder_;
  const std::function<Expected<void>()> restored_;
  services::Mutex mutex_;
};

/// Copies the files of the data folder into `to`, a folder that is not there yet, while a server may write. Errors:
/// `conflict` (there is something), `not_found` (no store in `data`), `storage`, `io`, `corrupt`.
Expected<void> copy_files(const std::filesystem::path& data, const std::filesystem::path& to);
/// Brings the files of a copy back into `data`, as Backups::restore.
Expected<void> restore_files(const std::filesystem::path& from, const std::filesystem::path& data,
                             const std::function<Expected<void>()>& begin);

/// Removes files of `data` that are damaged, so that those of a copy can take their place. Requires that nobody has
/// them open.
void remove_damaged(const std::filesystem::path& data);

/// schemas/backup.json
Value backup_json(const Backup& backup);

}  // namespace race::server
