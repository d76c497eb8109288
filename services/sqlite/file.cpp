#include "services/sqlite/file.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>

#include "services/sqlite/write_transaction.h"

namespace race::sqlite {
namespace {

constexpr int kBusyMs = 10'000;

// A commit is durable when it has returned. What a log has grown to is given back at the next checkpoint.
constexpr const char* kDurable =
    "PRAGMA journal_mode = WAL;"
    "PRAGMA synchronous = FULL;"
    "PRAGMA foreign_keys = ON;"
    "PRAGMA journal_size_limit = 16777216;";

int version_of(SQLite::Database& file) { return file.execAndGet("PRAGMA user_version").getInt(); }

ErrorCode code_of(int result) {
  switch (result & 0xFF) {  // the rest says more of the same
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return ErrorCode::corrupt;
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
      return ErrorCode::storage;
    default:
      return ErrorCode::io;
  }
}

/// Whether the disk gives the bytes of the file (SQLITE_FCNTL_FILE_POINTER) or its log (.._JOURNAL_POINTER).
bool can_be_read(SQLite::Database& file, int which) {
  sqlite3_file* opened = nullptr;
  sqlite3_file_control(file.getHandle(), "main", which, static_cast<void*>(&opened));
  if (!opened || !opened->pMethods) return true;
  sqlite3_int64 size = 0;
  if (opened->pMethods->xFileSize(opened, &size) != SQLITE_OK) return false;
  std::array<char, 65536> bytes;
  for (sqlite3_int64 at = 0; at < size; at += sqlite3_int64{bytes.size()}) {
    const int length = static_cast<int>(std::min(size - at, sqlite3_int64{bytes.size()}));
    const int result = opened->pMethods->xRead(opened, bytes.data(), length, at);
    if (result != SQLITE_OK && result != SQLITE_IOERR_SHORT_READ) return false;
  }
  return true;
}

std::string quick_check(SQLite::Database& file) { return file.execAndGet("PRAGMA quick_check(1)").getString(); }

}  // namespace

std::unique_ptr<SQLite::Database> open(const std::string& path) {
  auto file = std::make_unique<SQLite::Database>(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kBusyMs);
  file->exec(kDurable);
  return file;
}

std::unique_ptr<SQLite::Database> open_to_read(const std::string& path) {
  return std::make_unique<SQLite::Database>(path, SQLite::OPEN_READONLY, kBusyMs);
}

Expected<void> migrate(SQLite::Database& file, std::span<const Migration> migrations) try {
  const int last = static_cast<int>(migrations.size());
  if (version_of(file) > last)
    return unexpected(ErrorCode::version, "a newer version of the program wrote this file", file.getFilename());
  if (version_of(file) == last) return {};
  sqlite::WriteTransaction transaction(file);
  for (int version = version_of(file); version < last; ++version) {  // unless another process did it
    migrations[static_cast<std::size_t>(version)](file);
    file.exec("PRAGMA user_version = " + std::to_string(version + 1));
  }
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(error_of(exception, "cannot migrate " + file.getFilename()));
}

Expected<void> check(SQLite::Database& file) try {
  std::string found = quick_check(file);
  if (found != "ok") {  // which it also says of a page that the disk did not give
    if (!can_be_read(file, SQLITE_FCNTL_FILE_POINTER) || !can_be_read(file, SQLITE_FCNTL_JOURNAL_POINTER))
      return unexpected(ErrorCode::storage, "the disk fails", file.getFilename());
    found = quick_check(file);
  }
  if (found == "ok") return {};
  return unexpected(ErrorCode::corrupt, "the file is damaged: " + found, file.getFilename());
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(error_of(exception, "cannot check " + file.getFilename()));
}

Error error_of(const SQLite::Exception& exception, std::string_view what) {
  return {code_of(exception.getErrorCode()), std::string(what) + ": " + exception.what()};
}

}  // namespace race::sqlite
