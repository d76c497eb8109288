// Backups: copies of all that the server keeps, made and brought back while it runs. Each is a folder below `backups`
// of the data folder, named by its time (UTC):
//
//   20261122T143104.123Z/race.sqlite, database.sqlite   copies by SQLite's online backup; each of one moment
//   20261122T143104.123Z/digests.json                   the SHA-256 of each: a damaged backup is never brought back
//
// A backup appears whole or not at all: it is written beside, synchronised and renamed. race.sqlite is copied first:
// values of the database may be newer than the journals of runs that go on meanwhile.
//
// Threads: any. One at a time makes, removes or brings back; list() and find() wait for none of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/threads/stop.h"
#include "server/threads/work_progress.h"
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

  /// Who keeps something of the files.
  struct Users {
    /// Called before the files become others: what waits to be written is written now.
    std::function<void()> flush = [] {};
    /// Called when they have: who has read something reads it again. The error is that of restore().
    std::function<Expected<void>()> restored = [] { return Expected<void>(); };
  };
  /// Of the data folder `data`. What a crash has left of a backup is removed; one that another process is making, not.
  explicit Backups(std::filesystem::path data, Users users);
  explicit Backups(std::filesystem::path data) : Backups(std::move(data), Users{}) {}

  // Errors of all: `storage`, `io`, `corrupt`. A WorkProgress, which may be null, counts bytes of the files, each as
  // often as it is gone through (copy_files, restore_files).

  /// Copies everything as it is now. Errors: `conflict`: there are kMost already, or one of this millisecond;
  /// `unavailable`: stop().
  Expected<Backup> create(std::int64_t now_ms, WorkProgress* progress = nullptr) EXCLUDES(mutex_);
  /// Those that are whole, in order of time; also while one is being made.
  Expected<std::vector<Backup>> list() const;
  /// `not_found`
  Expected<Backup> find(const std::string& name) const;
  /// `not_found`
  Expected<Backup> remove(const std::string& name) EXCLUDES(mutex_);
  /// Makes the files what they were, and each in one transaction: who has them open sees the old content or the new.
  /// Requires that no run goes on. `begin` is called before anything is changed, when the backup is known to be sound;
  /// its error ends it. Errors, with nothing changed: `not_found`; `corrupt` (the backup is damaged); `version` (a
  /// newer version of the program made it); `unavailable` (stop(), before `begin`). If the disk fails between the two
  /// files, one is restored: restore again.
  Expected<Backup> restore(const std::string& name, const std::function<Expected<void>()>& begin,
                           WorkProgress* progress = nullptr) EXCLUDES(mutex_);
  /// What is being made, or is made later, ends soon, and so does what is brought back and has changed nothing yet: the
  /// server ends.
  void stop() { stop_ = true; }

 private:
  std::vector<Backup> all() const;

  const std::filesystem::path data_, folder_;
  const Users users_;
  Stop stop_{false};
  services::Mutex mutex_;
};

/// Copies the files of the data folder into `to`, a folder that is not there yet, while a server may write. Each file
/// is gone through three times: copied, checked, and read for its digest. Errors: `conflict` (there is something),
/// `not_found` (no store in `data`), `storage`, `io`, `corrupt`; `unavailable`: somebody has set `stop`, which may be
/// null, meanwhile: nothing is left of it.
Expected<void> copy_files(const std::filesystem::path& data, const std::filesystem::path& to,
                          const Stop* stop = nullptr, WorkProgress* progress = nullptr);
/// Brings the files of a copy back into `data`, as Backups::restore. Each is gone through three times: held against its
/// digest, brought to today's form beside, and put in its place. Runs that are created later have numbers after the
/// last one of the store that is replaced, if it can be read (run_numbers.h).
Expected<void> restore_files(const std::filesystem::path& from, const std::filesystem::path& data,
                             const std::function<Expected<void>()>& begin, const Stop* stop = nullptr,
                             WorkProgress* progress = nullptr);

/// Renames files of `data` that are damaged (`corrupt`) to NAME.damaged-TIME, with their logs, so that those of the
/// copy `from` can take their place; others are left alone. Requires that nobody has them open. Errors: `storage`,
/// `io`: a file cannot be read or renamed.
Expected<void> set_damaged_aside(const std::filesystem::path& data, const std::filesystem::path& from,
                                 std::int64_t now_ms);

/// schemas/backup.json
Value backup_json(const Backup& backup);

}  // namespace race::server
