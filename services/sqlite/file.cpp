#include "services/sqlite/file.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

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
  for (int version = version_of(file); version < last; ++version) {
    sqlite::WriteTransaction transaction(file);
    if (version_of(file) > version) continue;  // another process did it
    migrations[static_cast<std::size_t>(version)](file);
    file.exec("PRAGMA user_version = " + std::to_string(version + 1));
    transaction.commit();
  }
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(error_of(exception, "cannot migrate " + file.getFilename()));
}

Expected<void> check(SQLite::Database& file) try {
  const std::string found = file.execAndGet("PRAGMA quick_check(1)").getString();
  if (found == "ok") return {};
  return unexpected(ErrorCode::corrupt, "the file is damaged: " + found, file.getFilename());
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(error_of(exception, "cannot check " + file.getFilename()));
}

Error error_of(const SQLite::Exception& exception, std::string_view what) {
  return {code_of(exception.getErrorCode()), std::string(what) + ": " + exception.what()};
}

}  // namespace race::sqlite
