#include "services/database/store.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>

#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::database {
namespace {

// Durable before a function returns: the journal in write-ahead mode, flushed at every commit.
constexpr const char* kSetUp =
    "PRAGMA journal_mode = WAL;"
    "PRAGMA synchronous = FULL;"
    "CREATE TABLE IF NOT EXISTS entry (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;";

/// A statement with its texts bound. Throws as SQLiteCpp does.
SQLite::Statement prepare(SQLite::Database& file, const char* sql, std::initializer_list<std::string_view> texts) {
  SQLite::Statement statement(file, sql);
  int at = 0;
  for (const std::string_view text : texts) statement.bind(++at, std::string(text));
  return statement;
}

tl::unexpected<Error> failure(std::string_view what, const SQLite::Exception& exception) {
  return unexpected(ErrorCode::io, std::string(what) + ": " + exception.what());
}

std::string quoted(std::string_view key) { return "`" + std::string(key) + "`"; }

tl::unexpected<Error> no_such_key(std::string_view key) {
  return unexpected(ErrorCode::not_found, "the database has no " + quoted(key), std::string(key));
}

}  // namespace

Store::Store(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
Store::Store(Store&&) noexcept = default;
Store::~Store() = default;

Expected<Store> Store::open(const std::string& path) try {
  auto file = std::make_unique<SQLite::Database>(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  file->exec(kSetUp);
  return Store(std::move(file));
} catch (const SQLite::Exception& exception) {
  auto error = failure("cannot open the database", exception);
  error.value().path = path;
  return error;
}

Expected<Value> Store::get(std::string_view key) try {
  auto select = prepare(*file_, "SELECT value FROM entry WHERE key = ?", {key});
  if (!select.executeStep()) return no_such_key(key);
  return parse_json(select.getColumn(0).getString(), {.depth = kValueDepth, .bytes = kValueBytes});
} catch (const SQLite::Exception& exception) {
  return failure("cannot read " + quoted(key), exception);
}

Expected<void> Store::put(std::string_view key, const Value& value) try {
  if (key.empty() || key.size() > kKeyBytes)
    return unexpected(ErrorCode::out_of_range, "a key has 1 to " + std::to_string(kKeyBytes) + " bytes");
  if (deeper_than(value, kValueDepth))
    return unexpected(ErrorCode::too_deep, "a value has at most " + std::to_string(kValueDepth) + " levels");
  const std::string json = to_json(value);
  if (json.size() > kValueBytes)
    return unexpected(ErrorCode::too_large, "a value has at most " + std::to_string(kValueBytes) + " bytes");
  prepare(*file_, "INSERT INTO entry VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = excluded.value", {key, json})
      .exec();
  return {};
} catch (const SQLite::Exception& exception) {
  return failure("cannot store " + quoted(key), exception);
}

Expected<void> Store::remove(std::string_view key) try {
  if (prepare(*file_, "DELETE FROM entry WHERE key = ?", {key}).exec() == 0) return no_such_key(key);
  return {};
} catch (const SQLite::Exception& exception) {
  return failure("cannot remove " + quoted(key), exception);
}

Expected<std::vector<std::string>> Store::keys(std::string_view prefix) try {
  auto select = prepare(*file_, "SELECT key FROM entry WHERE substr(key, 1, length(?1)) = ?1 ORDER BY key", {prefix});
  std::vector<std::string> keys;
  while (select.executeStep()) keys.push_back(select.getColumn(0).getString());
  return keys;
} catch (const SQLite::Exception& exception) {
  return failure("cannot list keys", exception);
}

}  // namespace race::database
