#include "server/store/data_folder.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "server/store/backup.h"
#include "server/store/schema.h"
#include "server/wire/calendar.h"
#include "services/sqlite/file.h"
#include "services/sqlite/log_check.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

Expected<int> take_lock(const fs::path& folder) {
  const std::string path = folder / "lock";
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) return unexpected(ErrorCode::storage, std::strerror(errno), path);
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  const int error = errno;
  ::close(file);
  if (error == EWOULDBLOCK) return unexpected(ErrorCode::conflict, "another server uses this folder", folder);
  return unexpected(ErrorCode::storage, std::strerror(error), path);
}

// Older versions kept documents in a file of their own. Without its log, the file alone is all of it.
Expected<void> take_over_documents(const fs::path& folder) try {
  const fs::path old = folder / "documents.sqlite", store = folder / "race.sqlite";
  if (fs::exists(store) || !fs::exists(old)) return {};
  if (auto whole = sqlite::check_log(old); !whole) return whole;
  sqlite::open(old)->exec("PRAGMA journal_mode = DELETE");
  fs::rename(old, store);
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot take over documents.sqlite"));
} catch (const fs::filesystem_error& error) {
  return unexpected(ErrorCode::storage, error.what(), folder);
}

// The version of a store that holds anything; nothing: there is none.
std::optional<int> version_in(const fs::path& path) {
  if (!fs::exists(path) || fs::file_size(path) == 0) return {};
  const bool is_unfinished = fs::exists(path.string() + "-journal");  // who reads would have to roll it back
  const auto file = is_unfinished ? sqlite::open(path) : sqlite::open_to_read(path);
  if (file->execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0) return {};
  return file->execAndGet("PRAGMA user_version").getInt();
}

// One of a newer version is not opened to write, unless a crash has left a transaction to be rolled back. One of an
// older version is copied before it is changed: the name of the backup.
Expected<std::optional<std::string>> copy_older(const fs::path& folder, const fs::path& store) try {
  if (auto whole = sqlite::check_log(store); !whole) return tl::unexpected(std::move(whole).error());
  const auto version = version_in(store);
  const int last = static_cast<int>(store_migrations().size());
  if (version && *version > last)
    return unexpected(ErrorCode::version, "a newer version of the program wrote this file", store);
  if (!version || *version == last) return std::nullopt;
  ASSIGN_OR_RETURN(const Backup copy, Backups(folder).create(now_ms()));
  return copy.name;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the store"));
} catch (const fs::filesystem_error& error) {
  return unexpected(ErrorCode::storage, error.what(), store);
}

Expected<void> prepare(const fs::path& path) try {
  const auto file = sqlite::open(path);
  if (auto sound = sqlite::check(*file); !sound) return sound;
  return sqlite::migrate(*file, store_migrations());
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the store"));
}

}  // namespace

Expected<DataFolder> DataFolder::take(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return unexpected(ErrorCode::storage, error.message(), path);
  ASSIGN_OR_RETURN(const int lock, take_lock(path));
  return DataFolder(path, lock);
}

Expected<DataFolder> DataFolder::open(const std::string& path) {
  ASSIGN_OR_RETURN(DataFolder folder, take(path));
  auto ready = take_over_documents(path);
  if (ready) {
    auto copied = copy_older(path, folder.store());
    if (copied)
      folder.copy_before_upgrade_ = std::move(*copied);
    else
      ready = tl::unexpected(std::move(copied).error());
  }
  if (ready) ready = prepare(folder.store());
  if (!ready) {
    Error wrong = std::move(ready).error();
    if (wrong.path.empty()) wrong.path = folder.store();
    return tl::unexpected(std::move(wrong));
  }
  return folder;
}

DataFolder::DataFolder(DataFolder&& other) noexcept
    : path_(std::move(other.path_)),
      lock_(std::exchange(other.lock_, -1)),
      copy_before_upgrade_(std::move(other.copy_before_upgrade_)) {}

DataFolder::~DataFolder() {
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace race::server
