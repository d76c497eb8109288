#include "services/database/store.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "services/database/schema.h"
#include "services/sqlite/log_check.h"
#include "services/sqlite/table_hash.h"

namespace race::database {
namespace {

constexpr std::size_t kNamed = 3;  // damaged rows, in a message

/// A statement with its texts bound. Throws as SQLiteCpp does.
SQLite::Statement prepare(SQLite::Database& file, const char* sql, std::initializer_list<std::string_view> texts) {
  SQLite::Statement statement(file, sql);
  int at = 0;
  for (const std::string_view text : texts) statement.bind(++at, std::string(text));
  return statement;
}

tl::unexpected<Error> failure(std::string_view what, const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, what));
}

/// Returns its digest.
sqlite::Digest write_row(SQLite::Database& file, std::string_view key, const std::string& value) {
  const sqlite::Digest digest = digest_of(key, value);
  auto insert = prepare(file, "INSERT OR REPLACE INTO record VALUES (?, ?, ?)", {key, value});
  insert.bind(3, digest.data(), static_cast<int>(digest.size()));
  insert.exec();
  return digest;
}

tl::unexpected<Error> no_such_key(std::string_view key) {
  return unexpected(ErrorCode::not_found, "the database has no " + quote(key), std::string(key));
}

/// The value as it is stored, if the key and the value are within their limits.
Expected<std::string> json_of(std::string_view key, const Value& value) {
  if (key.empty() || key.size() > Store::kKeyBytes)
    return unexpected(ErrorCode::out_of_range, "a key has 1 to " + std::to_string(Store::kKeyBytes) + " bytes");
  if (deeper_than(value, Store::kValueDepth))
    return unexpected(ErrorCode::too_deep, "a value has at most " + std::to_string(Store::kValueDepth) + " levels");
  std::string json = to_json(value);
  if (json.size() > Store::kValueBytes)
    return unexpected(ErrorCode::too_large, "a value has at most " + std::to_string(Store::kValueBytes) + " bytes");
  return json;
}

}  // namespace

/// One row, as it is stored.
struct Store::Row {
  explicit Row(SQLite::Statement& select)
      : key(select.getColumn(0).getString()),
        value(select.getColumn(1).getString()),
        is_sound(select.getColumn(0).isText() && select.getColumn(1).isText()) {
    const std::string stored = select.getColumn(2).getString();
    if (stored.size() == digest.size()) stored.copy(reinterpret_cast<char*>(digest.data()), stored.size());
    is_sound = is_sound && stored.size() == digest.size() && digest == digest_of(key, value);
  }
  std::string key, value;
  sqlite::Digest digest = {};
  bool is_sound;  // its digest is that of its fields
};

/// What all rows come to.
struct Store::Found {
  sqlite::TableHash hash;
  std::size_t damaged = 0;
  std::string names;  // of the first damaged rows
};

Store::Store(std::unique_ptr<SQLite::Database> file, StoreLimits limits) : file_(std::move(file)), limits_(limits) {}
Store::Store(Store&&) noexcept = default;
Store::~Store() = default;

Expected<Store> Store::open(const std::string& path, StoreLimits limits) try {
  if (path != ":memory:")
    if (auto whole = sqlite::check_log(path); !whole) return tl::unexpected(std::move(whole).error());
  Store store(sqlite::open(path), limits);
  auto ready = sqlite::check(*store.file_);
  if (ready) ready = sqlite::migrate(*store.file_, migrations());
  if (ready) ready = sqlite::check_schema(*store.file_);
  if (ready) ready = store.check();
  if (ready) return store;
  ready.error().path = path;
  return tl::unexpected(std::move(ready).error());
} catch (const SQLite::Exception& exception) {
  auto error = failure("cannot open the database", exception);
  error.value().path = path;
  return error;
}

Store::Found Store::find_all() {
  SQLite::Statement select(*file_, "SELECT key, value, digest FROM record");
  Found found;
  while (select.executeStep()) {
    const Row row(select);
    found.hash.insert(row.digest);
    if (!row.is_sound && ++found.damaged <= kNamed)
      found.names += (found.names.empty() ? "" : ", ") + quote(std::string_view(row.key));
  }
  return found;
}

// A row that is damaged may have lost its own digest: then the sums differ and no row is lost.
Expected<void> Store::check() {
  const Found found = find_all();
  ASSIGN_OR_RETURN(const sqlite::TableHash kept, sqlite::TableHash::read(*file_, kRecords));
  damaged_ = found.damaged > 0;
  if (found.hash == kept || (damaged_ && found.hash.rows == kept.rows)) return {};
  return unexpected(ErrorCode::corrupt, "the database is damaged: " + std::to_string(found.hash.rows) + " rows of " +
                                            std::to_string(kept.rows) + " are there, or one is not the stored one");
}

// Damage may have been removed since, by a change of its row or a restored backup.
Expected<void> Store::sound() {
  if (!damaged_) return {};
  const Found found = find_all();
  damaged_ = found.damaged > 0;
  if (!damaged_) return {};
  return unexpected(ErrorCode::corrupt,
                    std::to_string(found.damaged) + " damaged rows are in the database: " + found.names);
}

std::unique_ptr<Store::Row> Store::find(std::string_view key) {
  auto select = prepare(*file_, "SELECT key, value, digest FROM record WHERE key = ?", {key});
  return select.executeStep() ? std::make_unique<Row>(select) : nullptr;
}

Expected<Value> Store::get(std::string_view key) try {
  const auto row = find(key);
  if (row && row->is_sound) return parse_json(row->value, {.depth = kValueDepth, .bytes = kValueBytes});
  if (row) return unexpected(ErrorCode::corrupt, "the value of " + quote(key) + " is damaged", std::string(key));
  if (auto complete = sound(); !complete) return tl::unexpected(std::move(complete).error());
  return no_such_key(key);
} catch (const SQLite::Exception& exception) {
  return failure("cannot read " + quote(key), exception);
}

Expected<void> Store::put(std::string_view key, const Value& value) try {
  ASSIGN_OR_RETURN(const std::string json, json_of(key, value));
  return change(key, &json);
} catch (const SQLite::Exception& exception) {
  return failure("cannot store " + quote(key), exception);
}

Expected<void> Store::replace_all(const Dict& values) try {
  SQLite::Transaction transaction(*file_, SQLite::TransactionBehavior::IMMEDIATE);
  file_->exec("DELETE FROM record");
  sqlite::TableHash hash;
  for (const auto& [key, value] : values) {
    ASSIGN_OR_RETURN(const std::string json, json_of(key.as_string(), value));
    hash.insert(write_row(*file_, key.as_string(), json));
  }
  hash.write(*file_, kRecords);
  transaction.commit();
  damaged_ = false;
  return {};
} catch (const SQLite::Exception& exception) {
  return failure("cannot replace the values", exception);
}

Expected<void> Store::remove(std::string_view key) try {
  return change(key, nullptr);
} catch (const SQLite::Exception& exception) {
  return failure("cannot remove " + quote(key), exception);
}

// As SQLite counts it, so that it is right also in a transaction and after a backup was restored.
std::uint64_t Store::used_bytes() const {
  const auto read = [this](const char* pragma) { return file_->execAndGet(pragma).getInt64(); };
  return static_cast<std::uint64_t>((read("PRAGMA page_count") - read("PRAGMA freelist_count")) *
                                    read("PRAGMA page_size"));
}

/// Stores the JSON `value`, or removes the row: with the hash of the table, in one transaction.
Expected<void> Store::change(std::string_view key, const std::string* value) {
  SQLite::Transaction transaction(*file_, SQLite::TransactionBehavior::IMMEDIATE);
  const auto old = find(key);
  if (!value && !old) {
    if (auto complete = sound(); !complete) return complete;
    return no_such_key(key);
  }
  ASSIGN_OR_RETURN(sqlite::TableHash hash, sqlite::TableHash::read(*file_, kRecords));
  if (value && !old && hash.rows >= limits_.keys)
    return unexpected(ErrorCode::too_large, "the database has " + std::to_string(hash.rows) + " keys already");
  if (old) hash.remove(old->digest);
  const std::uint64_t bytes_before = used_bytes();
  if (value) {
    hash.insert(write_row(*file_, key, *value));
  } else {
    prepare(*file_, "DELETE FROM record WHERE key = ?", {key}).exec();
  }
  if (old && !old->is_sound) hash = find_all().hash;  // what the damaged digest was is not known
  hash.write(*file_, kRecords);
  if (const std::uint64_t bytes = used_bytes(); bytes > limits_.bytes && bytes > bytes_before)
    return unexpected(ErrorCode::too_large, "the database is full: it has " + std::to_string(bytes_before) + " bytes");
  transaction.commit();
  return {};
}

Expected<std::vector<std::string>> Store::keys(std::string_view prefix) try {
  if (auto complete = sound(); !complete) return tl::unexpected(std::move(complete).error());
  auto select = prepare(*file_, "SELECT key FROM record WHERE substr(key, 1, length(?1)) = ?1 ORDER BY key", {prefix});
  std::vector<std::string> keys;
  std::size_t bytes = 0;
  while (select.executeStep()) {
    bytes += keys.emplace_back(select.getColumn(0).getString()).size();
    if (bytes > kValueBytes) return unexpected(ErrorCode::too_large, "there are too many of these keys");
  }
  return keys;
} catch (const SQLite::Exception& exception) {
  return failure("cannot list keys", exception);
}

}  // namespace race::database
