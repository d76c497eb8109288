#include "server/store/backup.h"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Transaction.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <optional>
#include <span>
#include <string_view>
#include <thread>

#include "core/value/json.h"
#include "server/store/damaged_file.h"
#include "server/store/document_removal.h"
#include "server/store/durable_files.h"
#include "server/store/files.h"
#include "server/store/run_numbers.h"
#include "server/store/run_removal.h"
#include "server/store/schema.h"
#include "server/store/unfinished_folder.h"
#include "services/database/schema.h"
#include "services/sqlite/digest.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDigests = "digests.json";
constexpr std::string_view kStore = "race.sqlite";
constexpr const char* kRestore = "restore";  // copies that are being brought back
constexpr int kPagesAtOnce = 256;            // of a copy, between two looks at who waits for it
constexpr std::uint64_t kPasses = 3;         // how often a file is gone through, by a backup and by its restore

struct StoredFile {
  const char* name;
  std::span<const sqlite::Migration> (*migrations)();
};
constexpr std::array kFiles = {StoredFile{kStore.data(), store_migrations},
                               StoredFile{"database.sqlite", database::migrations}};

tl::unexpected<Error> cannot(const std::string& what, const SQLite::Exception& exception, const fs::path& path) {
  Error error = sqlite::error_of(exception, what);
  error.path = path;
  return tl::unexpected(std::move(error));
}

tl::unexpected<Error> cannot(const std::string& what, const fs::filesystem_error& error) {
  return unexpected(ErrorCode::storage, what + ": " + error.code().message(), error.path1());
}

/// Error `unavailable`: nobody waits any more.
Expected<void> unless_stopped(const Stop* stop) {
  if (stop && *stop) return unexpected(ErrorCode::unavailable, "the server ends");
  return {};
}

/// 0: it is not there, or does not say.
std::uint64_t bytes_of(const fs::path& file) {
  std::error_code unknown;
  const std::uintmax_t bytes = fs::file_size(file, unknown);
  return unknown ? 0 : bytes;
}

/// Of the files in a folder, each as often as it is gone through.
WorkParts parts_of(const fs::path& folder, WorkProgress* progress) {
  std::uint64_t bytes = 0;
  for (const StoredFile& file : kFiles) bytes += bytes_of(folder / file.name);
  return {progress, kPasses * bytes, "bytes"};
}

/// Makes `to` what `from` is now, in one transaction of `to`. A writer may hold `to` for a moment.
Expected<void> copy(SQLite::Database& from, SQLite::Database& to, const WorkPart& part, const Stop* stop) {
  // What others write to `from` meanwhile is not seen; else the copy would begin anew with each change.
  const SQLite::Transaction reading(from);
  from.execAndGet("SELECT count(*) FROM sqlite_schema");
  SQLite::Backup backup(to, from);
  for (int tries = 0; tries < 250;) {
    const int result = backup.executeStep(kPagesAtOnce);
    const int pages = backup.getTotalPageCount();
    part.reach(static_cast<std::uint64_t>(pages - backup.getRemainingPageCount()), static_cast<std::uint64_t>(pages));
    if (result == SQLITE_DONE) return {};
    if (auto wanted = unless_stopped(stop); !wanted) return wanted;
    if (result == SQLITE_OK) continue;
    ++tries;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return unexpected(ErrorCode::unavailable, "the file is in use", to.getFilename());
}

/// A file that is alone all there is, without a log: copied and checked, which are parts of so many bytes each.
Expected<void> copy_whole(const fs::path& from, const fs::path& to, std::uint64_t bytes, WorkParts& parts,
                          const Stop* stop) try {
  const auto source = sqlite::open(from);
  const auto copied = sqlite::open(to);
  if (auto done = copy(*source, *copied, parts.next(bytes), stop); !done) return done;
  copied->exec("PRAGMA journal_mode = DELETE");
  if (auto sound = sqlite::check(*copied); !sound) return sound;
  parts.next(bytes).finish();
  return unless_stopped(stop);
} catch (const SQLite::Exception& exception) {
  return cannot("cannot copy", exception, from);
}

Expected<std::string> digest_of(const fs::path& path, const WorkPart& part) {
  const std::uint64_t bytes = bytes_of(path);
  ASSIGN_OR_RETURN(const sqlite::Digest digest,
                   sqlite::sha256_of_file(path, [&](std::uint64_t read) { part.reach(read, bytes); }));
  return sqlite::hex(digest);
}

Expected<void> copy_all(const fs::path& data, const fs::path& to, const Stop* stop, WorkProgress* progress) {
  WorkParts parts = parts_of(data, progress);
  Dict digests;
  for (const StoredFile& file : kFiles) {
    if (!fs::exists(data / file.name)) continue;
    const std::uint64_t bytes = bytes_of(data / file.name);
    if (auto done = copy_whole(data / file.name, to / file.name, bytes, parts, stop); !done) return done;
    ASSIGN_OR_RETURN(std::string digest, digest_of(to / file.name, parts.next(bytes)));
    digests.set(file.name, std::move(digest));
  }
  if (auto written = write_durably(to / kDigests, to_json(Value(std::move(digests)))); !written) return written;
  return synchronise_folder(to);
}

/// The names of the files in a copy, each held against its digest.
Expected<std::vector<StoredFile>> sound_files(const fs::path& from, WorkParts& parts) {
  const auto damaged = [&](const std::string& message) { return unexpected(ErrorCode::corrupt, message, from); };
  ASSIGN_OR_RETURN(const std::string text, read_file(from / kDigests));
  const auto digests = parse_json(text);
  if (!digests || !digests->is_dict()) return damaged("the backup is damaged: its digests are no JSON");
  std::vector<StoredFile> files;
  for (const StoredFile& file : kFiles) {
    const Value* expected = digests->as_dict().find(file.name);
    if (!expected && !fs::exists(from / file.name)) continue;
    ASSIGN_OR_RETURN(std::string digest, digest_of(from / file.name, parts.next(bytes_of(from / file.name))));
    if (!expected || *expected != Value(digest)) return damaged("the backup is damaged: " + std::string(file.name));
    files.push_back(file);
  }
  if (files.size() != digests->as_dict().size() || files.empty() || files.front().name != kFiles.front().name)
    return damaged("the backup is damaged: a file is not there");
  return files;
}

/// The last number of a run in a store; 0: it does not say.
RunId last_number_in(const fs::path& store) try {
  if (!fs::exists(store)) return 0;
  return last_run_number(*sqlite::open_to_read(store));
} catch (const SQLite::Exception&) {  // damaged, or of an older version
  return 0;
}

/// A copy of the backup, in today's form.
Expected<void> prepare(const fs::path& from, const fs::path& to, const StoredFile& file) try {
  fs::copy_file(from / file.name, to / file.name);
  const auto opened = sqlite::open(to / file.name);
  if (auto sound = sqlite::check(*opened); !sound) return sound;
  if (auto done = sqlite::migrate(*opened, file.migrations()); !done) return done;
  if (file.name == kStore) {
    finish_removals(*opened);
    finish_document_removals(*opened);
  }
  return {};
} catch (const SQLite::Exception& exception) {
  return cannot("cannot open the backup", exception, from);
}

void raise_numbers(SQLite::Database& store, RunId last) {
  sqlite::WriteTransaction transaction(store);
  raise_run_numbers(store, last);
  transaction.commit();
}

/// Makes the file of the data folder what the copy is. Runs that are created later have numbers after `last_run`, and
/// after that of a run that is created until now: other writers wait.
Expected<void> replace(const fs::path& copied, const fs::path& data, const StoredFile& file, RunId last_run,
                       const WorkPart& part) try {
  const auto source = sqlite::open(copied / file.name);
  const auto live = sqlite::open(data / file.name);
  const sqlite::WriteTurn turn(*live);
  if (file.name == kStore) raise_numbers(*source, std::max(last_run, last_number_in(data / file.name)));
  return copy(*source, *live, part, nullptr);
} catch (const SQLite::Exception& exception) {
  return cannot("cannot restore", exception, data / file.name);
}

std::string name_of(std::int64_t now_ms) {
  const std::time_t seconds = now_ms / 1000;
  std::tm utc = {};
  ::gmtime_r(&seconds, &utc);
  std::array<char, 32> day{};
  std::strftime(day.data(), day.size(), "%Y%m%dT%H%M%S", &utc);
  return day.data() + ("." + std::to_string(1000 + now_ms % 1000).substr(1)) + "Z";
}

/// The time that a name says; none: it is no name of a backup.
std::optional<std::int64_t> time_of(const std::string& name) {
  std::tm utc = {};
  int ms = 0;
  if (std::sscanf(name.c_str(), "%4d%2d%2dT%2d%2d%2d.%3dZ", &utc.tm_year, &utc.tm_mon, &utc.tm_mday, &utc.tm_hour,
                  &utc.tm_min, &utc.tm_sec, &ms) != 7)
    return {};
  utc.tm_year -= 1900;
  --utc.tm_mon;
  const std::int64_t time = std::int64_t{::timegm(&utc)} * 1000 + ms;
  if (name_of(time) != name) return {};
  return time;
}

}  // namespace

Expected<void> copy_files(const fs::path& data, const fs::path& to, const Stop* stop, WorkProgress* progress) try {
  if (!fs::exists(data / kStore)) return unexpected(ErrorCode::not_found, "holds no store", data);
  if (fs::exists(to)) return unexpected(ErrorCode::conflict, "is there already", to);
  fs::path whole = fs::absolute(to).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();  // of `to/`
  fs::create_directories(whole.parent_path());
  UnfinishedFolder::remove_abandoned(whole.parent_path(), whole.filename());
  ASSIGN_OR_RETURN(UnfinishedFolder beside, UnfinishedFolder::create(whole));
  if (auto done = copy_all(data, beside.path(), stop, progress); !done) return done;
  return beside.finish();
} catch (const fs::filesystem_error& error) {
  return cannot("cannot write the backup", error);
}

// Values first: what a crash leaves between the files can be brought back once more.
Expected<void> restore_files(const fs::path& from, const fs::path& data, const std::function<Expected<void>()>& begin,
                             const Stop* stop, WorkProgress* progress) try {
  WorkParts parts = parts_of(from, progress);
  ASSIGN_OR_RETURN(const std::vector<StoredFile> files, sound_files(from, parts));
  UnfinishedFolder::remove_abandoned(data, kRestore);
  ASSIGN_OR_RETURN(const UnfinishedFolder copies, UnfinishedFolder::create(fs::absolute(data) / kRestore));
  for (const StoredFile& file : files) {
    if (auto wanted = unless_stopped(stop); !wanted) return wanted;
    if (auto done = prepare(from, copies.path(), file); !done) return done;
    parts.next(bytes_of(from / file.name)).finish();
  }
  const RunId last_run = last_number_in(data / kStore);  // before it may be set aside
  if (auto wanted = unless_stopped(stop); !wanted) return wanted;
  if (auto done = begin(); !done) return done;
  for (auto file = files.rbegin(); file != files.rend(); ++file) {
    const WorkPart part = parts.next(bytes_of(from / file->name));
    if (auto done = replace(copies.path(), data, *file, last_run, part); !done) return done;
  }
  return {};
} catch (const fs::filesystem_error& error) {
  return cannot("cannot restore", error);
}

Expected<void> set_damaged_aside(const fs::path& data, const fs::path& from, std::int64_t now_ms) {
  for (const StoredFile& file : kFiles) {
    if (!fs::exists(from / file.name)) continue;
    if (auto done = set_aside_if_damaged(data / file.name, name_of(now_ms)); !done) return done;
  }
  return {};
}

Backups::Backups(fs::path data, Users users)
    : data_(std::move(data)), folder_(data_ / "backups"), users_(std::move(users)) {
  UnfinishedFolder::remove_abandoned(folder_);
}

Expected<Backup> Backups::create(std::int64_t now_ms, WorkProgress* progress) try {
  const services::MutexLock lock(mutex_);
  if (all().size() >= kMost)
    return unexpected(ErrorCode::conflict, "there are " + std::to_string(kMost) + " backups; remove one");
  fs::create_directories(folder_);
  const std::string name = name_of(now_ms);
  if (auto done = copy_files(data_, folder_ / name, &stop_, progress); !done)
    return tl::unexpected(std::move(done).error());
  return find(name);
} catch (const fs::filesystem_error& error) {
  return cannot("cannot write the backup", error);
}

Expected<std::vector<Backup>> Backups::list() const try { return all(); } catch (const fs::filesystem_error& error) {
  return cannot("cannot list backups", error);
}

Expected<Backup> Backups::remove(const std::string& name) try {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(Backup backup, find(name));
  const fs::path away = UnfinishedFolder::abandon(folder_ / name);  // one that is removed in part is none
  fs::remove_all(away);
  return backup;
} catch (const fs::filesystem_error& error) {
  return cannot("cannot remove the backup", error);
}

Expected<Backup> Backups::restore(const std::string& name, const std::function<Expected<void>()>& begin,
                                  WorkProgress* progress) try {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(Backup backup, find(name));
  const auto ready = [&] {
    auto done = begin();
    if (done) users_.flush();
    return done;
  };
  if (auto done = restore_files(folder_ / name, data_, ready, &stop_, progress); !done)
    return tl::unexpected(std::move(done).error());
  if (auto done = users_.restored(); !done) return tl::unexpected(std::move(done).error());
  return backup;
} catch (const fs::filesystem_error& error) {
  return cannot("cannot restore", error);
}

Expected<Backup> Backups::find(const std::string& name) const {
  const auto time = time_of(name);
  std::error_code gone;  // while list() reads, another thread may remove it
  auto files = time ? fs::directory_iterator(folder_ / name, gone) : fs::directory_iterator();
  Backup backup{name, time.value_or(0), 0};
  while (!gone && files != fs::directory_iterator()) {
    backup.bytes += files->file_size(gone);
    if (!gone) files.increment(gone);
  }
  if (!time || gone) return unexpected(ErrorCode::not_found, "there is no such backup", name);
  return backup;
}

std::vector<Backup> Backups::all() const {
  std::vector<Backup> backups;
  if (!fs::exists(folder_)) return backups;
  for (const auto& entry : fs::directory_iterator(folder_))
    if (auto backup = find(entry.path().filename())) backups.push_back(std::move(*backup));
  std::ranges::sort(backups, {}, &Backup::created_ms);
  return backups;
}

Value backup_json(const Backup& backup) {
  return Dict{
      {"name", backup.name}, {"created", backup.created_ms}, {"bytes", static_cast<std::int64_t>(backup.bytes)}};
}

}  // namespace race::server
