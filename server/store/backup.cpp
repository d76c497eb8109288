#include "server/store/backup.h"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <optional>
#include <span>
#include <thread>

#include "core/value/json.h"
#include "server/store/durable_files.h"
#include "server/store/files.h"
#include "server/store/schema.h"
#include "services/database/schema.h"
#include "services/sqlite/digest.h"
#include "services/sqlite/file.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDigests = "digests.json";
constexpr const char* kUnfinished = ".unfinished";  // a backup that is being made, or a copy that is being brought back

struct StoredFile {
  const char* name;
  std::span<const sqlite::Migration> (*migrations)();
};
constexpr std::array kFiles = {StoredFile{"race.sqlite", store_migrations},
                               StoredFile{"database.sqlite", database::migrations}};

tl::unexpected<Error> cannot(const std::string& what, const SQLite::Exception& exception, const fs::path& path) {
  Error error = sqlite::error_of(exception, what);
  error.path = path;
  return tl::unexpected(std::move(error));
}

tl::unexpected<Error> cannot(const std::string& what, const fs::filesystem_error& error) {
  return unexpected(ErrorCode::storage, what + ": " + error.code().message(), error.path1());
}

/// Makes `to` what `from` is, in one transaction of `to`. A writer may hold `to` for a moment.
Expected<void> copy(SQLite::Database& from, SQLite::Database& to) {
  SQLite::Backup backup(to, from);
  for (int tries = 0; tries < 250; ++tries) {
    if (backup.executeStep(-1) == SQLITE_DONE) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return unexpected(ErrorCode::unavailable, "the file is in use", to.getFilename());
}

/// A file that is alone all there is: without a log.
Expected<void> copy_whole(const fs::path& from, const fs::path& to) try {
  const auto source = sqlite::open(from);
  const auto copied = sqlite::open(to);
  if (auto done = copy(*source, *copied); !done) return done;
  copied->exec("PRAGMA journal_mode = DELETE");
  return sqlite::check(*copied);
} catch (const SQLite::Exception& exception) {
  return cannot("cannot copy", exception, from);
}

Expected<std::string> digest_of(const fs::path& path) {
  ASSIGN_OR_RETURN(const sqlite::Digest digest, sqlite::sha256_of_file(path));
  return sqlite::hex(digest);
}

Expected<void> copy_all(const fs::path& data, const fs::path& to) {
  Dict digests;
  for (const StoredFile& file : kFiles) {
    if (!fs::exists(data / file.name)) continue;
    if (auto done = copy_whole(data / file.name, to / file.name); !done) return done;
    ASSIGN_OR_RETURN(std::string digest, digest_of(to / file.name));
    digests.set(file.name, std::move(digest));
  }
  if (auto written = write_durably(to / kDigests, to_json(Value(std::move(digests)))); !written) return written;
  return synchronise_folder(to);
}

/// The names of the files in a copy, each held against its digest.
Expected<std::vector<StoredFile>> sound_files(const fs::path& from) {
  const auto damaged = [&](const std::string& message) { return unexpected(ErrorCode::corrupt, message, from); };
  ASSIGN_OR_RETURN(const std::string text, read_file(from / kDigests));
  const auto digests = parse_json(text);
  if (!digests || !digests->is_dict()) return damaged("the backup is damaged: its digests are no JSON");
  std::vector<StoredFile> files;
  for (const StoredFile& file : kFiles) {
    const Value* expected = digests->as_dict().find(file.name);
    if (!expected && !fs::exists(from / file.name)) continue;
    ASSIGN_OR_RETURN(std::string digest, digest_of(from / file.name));
    if (!expected || *expected != Value(digest)) return damaged("the backup is damaged: " + std::string(file.name));
    files.push_back(file);
  }
  if (files.size() != digests->as_dict().size() || files.empty() || files.front().name != kFiles.front().name)
    return damaged("the backup is damaged: a file is not there");
  return files;
}

/// A copy of the backup, in today's form.
Expected<void> prepare(const fs::path& from, const fs::path& to, const StoredFile& file) try {
  fs::copy_file(from / file.name, to / file.name);
  const auto opened = sqlite::open(to / file.name);
  if (auto sound = sqlite::check(*opened); !sound) return sound;
  return sqlite::migrate(*opened, file.migrations());
} catch (const SQLite::Exception& exception) {
  return cannot("cannot open the backup", exception, from);
}

// Values first: what a crash leaves between the files can be brought back once more.
Expected<void> bring_back(const fs::path& from, const fs::path& data, std::vector<StoredFile> files) {
  std::ranges::reverse(files);
  for (const StoredFile& file : files) try {
      const auto source = sqlite::open(from / file.name);
      const auto live = sqlite::open(data / file.name);
      if (auto done = copy(*source, *live); !done) return done;
    } catch (const SQLite::Exception& exception) {
      return cannot("cannot restore", exception, data / file.name);
    }
  return {};
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

Expected<void> copy_files(const fs::path& data, const fs::path& to) try {
  if (!fs::exists(data / kFiles.front().name)) return unexpected(ErrorCode::not_found, "holds no store", data);
  if (fs::exists(to)) return unexpected(ErrorCode::conflict, "is there already", to);
  fs::path whole = fs::absolute(to).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();  // of `to/`
  const fs::path beside = whole.parent_path() / (whole.filename().string() + kUnfinished);
  fs::remove_all(beside);
  fs::create_directories(beside);
  auto done = copy_all(data, beside);
  if (done) {
    fs::rename(beside, whole);
    return synchronise_folder(whole.parent_path());
  }
  std::error_code unknown;
  fs::remove_all(beside, unknown);
  return done;
} catch (const fs::filesystem_error& error) {
  return cannot("cannot write the backup", error);
}

Expected<void> restore_files(const fs::path& from, const fs::path& data,
                             const std::function<Expected<void>()>& begin) try {
  ASSIGN_OR_RETURN(std::vector<StoredFile> files, sound_files(from));
  const fs::path copies = data / (std::string("restore") + kUnfinished);
  fs::remove_all(copies);
  fs::create_directories(copies);
  Expected<void> done;
  for (const StoredFile& file : files)
    if (done) done = prepare(from, copies, file);
  if (done) done = begin();
  if (done) done = bring_back(copies, data, std::move(files));
  std::error_code unknown;
  fs::remove_all(copies, unknown);
  return done;
} catch (const fs::filesystem_error& error) {
  return cannot("cannot restore", error);
}

void remove_damaged(const fs::path& data) {
  for (const StoredFile& file : kFiles) {
    const std::string path = data / file.name;
    bool sound = false;
    try {
      sound = sqlite::check(*sqlite::open(path)).has_value();
    } catch (const SQLite::Exception&) {  // so it is not
    }
    std::error_code unknown;
    if (!sound)
      for (const char* suffix : {"-wal", "-shm", ""}) fs::remove(path + suffix, unknown);
  }
}

Backups::Backups(fs::path data, std::function<Expected<void>()> restored)
    : data_(std::move(data)), folder_(data_ / "backups"), restored_(std::move(restored)) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder_, none))
    if (entry.path().extension() == kUnfinished) fs::remove_all(entry.path(), none);
}

Expected<Backup> Backups::create(std::int64_t now_ms) try {
  const services::MutexLock lock(mutex_);
  if (all().size() >= kMost)
    return unexpected(ErrorCode::conflict, "there are " + std::to_string(kMost) + " backups; remove one");
  fs::create_directories(folder_);
  const std::string name = name_of(now_ms);
  if (auto done = copy_files(data_, folder_ / name); !done) return tl::unexpected(std::move(done).error());
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
  const fs::path away = folder_ / (name + kUnfinished);  // one that is removed in part is none
  fs::rename(folder_ / name, away);
  fs::remove_all(away);
  return backup;
} catch (const fs::filesystem_error& error) {
  return cannot("cannot remove the backup", error);
}

Expected<Backup> Backups::restore(const std::string& name, const std::function<Expected<void>()>& begin) try {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(Backup backup, find(name));
  if (auto done = restore_files(folder_ / name, data_, begin); !done) return tl::unexpected(std::move(done).error());
  if (auto done = restored_(); !done) return tl::unexpected(std::move(done).error());
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
