#include "services/database/store.h"

#include <sqlite3.h>

#include <algorithm>

#include "core/value/json.h"

namespace race::database {
namespace {

// Durable before a function returns: the journal in write-ahead mode, flushed at every commit.
constexpr const char* kSetUp =
    "PRAGMA journal_mode = WAL;"
    "PRAGMA synchronous = FULL;"
    "CREATE TABLE IF NOT EXISTS entry (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;";

/// One statement with its texts bound; finalised at the end of its scope.
class Statement {
 public:
  Statement(sqlite3* file, const char* sql, std::initializer_list<std::string_view> texts) {
    if (sqlite3_prepare_v2(file, sql, -1, &statement_, nullptr) != SQLITE_OK) return;
    int at = 0;
    for (const std::string_view text : texts)
      sqlite3_bind_text(statement_, ++at, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  int step() { return statement_ ? sqlite3_step(statement_) : SQLITE_ERROR; }
  std::string_view text() const {
    return {reinterpret_cast<const char*>(sqlite3_column_text(statement_, 0)),
            static_cast<std::size_t>(sqlite3_column_bytes(statement_, 0))};
  }

 private:
  sqlite3_stmt* statement_ = nullptr;
};

bool deeper_than(const Value& value, std::size_t levels) {
  if (!value.is_list() && !value.is_dict()) return false;
  if (levels == 0) return true;
  if (value.is_list())
    return std::any_of(value.as_list().begin(), value.as_list().end(),
                       [&](const Value& item) { return deeper_than(item, levels - 1); });
  return std::any_of(value.as_dict().begin(), value.as_dict().end(),
                     [&](const Dict::Entry& entry) { return deeper_than(entry.second, levels - 1); });
}

std::string quoted(std::string_view key) { return "`" + std::string(key) + "`"; }

}  // namespace

void Store::Close::operator()(sqlite3* file) const { sqlite3_close_v2(file); }

Error Store::failure(std::string_view what) const {
  return {ErrorCode::io, std::string(what) + ": " + sqlite3_errmsg(file_.get())};
}

Expected<Store> Store::open(const std::string& path) {
  sqlite3* file = nullptr;
  const int opened = sqlite3_open_v2(path.c_str(), &file, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  Store store(file);
  if (opened != SQLITE_OK || sqlite3_exec(file, kSetUp, nullptr, nullptr, nullptr) != SQLITE_OK) {
    Error error = store.failure("cannot open the database");
    error.path = path;
    return tl::unexpected(std::move(error));
  }
  return store;
}

Expected<Value> Store::get(std::string_view key) {
  Statement select(file_.get(), "SELECT value FROM entry WHERE key = ?", {key});
  switch (select.step()) {
    case SQLITE_ROW:
      return parse_json(select.text(), {.depth = kValueDepth, .bytes = kValueBytes});
    case SQLITE_DONE:
      return unexpected(ErrorCode::not_found, "the database has no " + quoted(key), std::string(key));
    default:
      return tl::unexpected(failure("cannot read " + quoted(key)));
  }
}

Expected<void> Store::put(std::string_view key, const Value& value) {
  if (key.empty() || key.size() > kKeyBytes)
    return unexpected(ErrorCode::out_of_range, "a key has 1 to " + std::to_string(kKeyBytes) + " bytes");
  if (deeper_than(value, kValueDepth))
    return unexpected(ErrorCode::too_deep, "a value has at most " + std::to_string(kValueDepth) + " levels");
  const std::string json = to_json(value);
  if (json.size() > kValueBytes)
    return unexpected(ErrorCode::too_large, "a value has at most " + std::to_string(kValueBytes) + " bytes");
  Statement insert(file_.get(),
                   "INSERT INTO entry VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = excluded.value",
                   {key, json});
  if (insert.step() != SQLITE_DONE) return tl::unexpected(failure("cannot store " + quoted(key)));
  return {};
}

Expected<void> Store::remove(std::string_view key) {
  Statement erase(file_.get(), "DELETE FROM entry WHERE key = ?", {key});
  if (erase.step() != SQLITE_DONE) return tl::unexpected(failure("cannot remove " + quoted(key)));
  if (sqlite3_changes(file_.get()) == 0)
    return unexpected(ErrorCode::not_found, "the database has no " + quoted(key), std::string(key));
  return {};
}

Expected<std::vector<std::string>> Store::keys(std::string_view prefix) {
  Statement select(file_.get(), "SELECT key FROM entry WHERE substr(key, 1, length(?1)) = ?1 ORDER BY key", {prefix});
  std::vector<std::string> keys;
  int status = SQLITE_DONE;
  while ((status = select.step()) == SQLITE_ROW) keys.emplace_back(select.text());
  if (status != SQLITE_DONE) return tl::unexpected(failure("cannot list keys"));
  return keys;
}

}  // namespace race::database
