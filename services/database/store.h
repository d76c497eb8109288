// Store: values by key in one SQLite file. Each change is durable when the function returns. What the disk has damaged
// is never taken for a value: a damaged value is an error that names its key, and the others can be used.
//
// Threads: one at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace SQLite {
class Database;
}

namespace race::database {

/// Of all that a store has. A file with more is read, and takes nothing that makes it larger.
struct StoreLimits {
  std::uint64_t keys = 100'000;
  std::uint64_t bytes = 256 * 1024 * 1024;  // of the pages of the file that are in use
};

class Store {
 public:
  static constexpr std::size_t kKeyBytes = 1000;
  static constexpr std::size_t kValueBytes = 16 * 1024 * 1024;  // of its JSON
  static constexpr std::size_t kValueDepth = 64;
  /// Opens the file, or makes it; ":memory:" is a store in memory. Reads and checks all of it. Errors: `storage`, `io`;
  /// `corrupt` (its structure or its log is damaged, or a row is lost), `version` (a newer version of the program wrote
  /// it).
  static Expected<Store> open(const std::string& path, StoreLimits limits = {});
  Store(Store&&) noexcept;
  ~Store();

  /// Errors of all: `storage` (the disk is full or fails: nothing is changed), `io`; `corrupt`: what is stored is
  /// damaged. `not_found`: no such key; `corrupt` instead while there is a row of which the key may be damaged.
  Expected<Value> get(std::string_view key);
  /// Stores `value` under `key`, over an old one, also a damaged one. Errors: `out_of_range` (an empty or long key),
  /// `too_large` (the value, or the database is full), `too_deep`.
  Expected<void> put(std::string_view key, const Value& value);
  /// These become the only keys, in one transaction. Errors: those of put().
  Expected<void> replace_all(const Dict& values);
  /// A damaged one, too. `not_found`: no such key.
  Expected<void> remove(std::string_view key);
  /// The keys that begin with `prefix`, in order of their bytes. `corrupt`, naming damaged rows, while there are any;
  /// `too_large`: they come to more than kValueBytes.
  Expected<std::vector<std::string>> keys(std::string_view prefix);

 private:
  struct Row;
  struct Found;
  Store(std::unique_ptr<SQLite::Database> file, StoreLimits limits);
  Found find_all();
  Expected<void> check();
  Expected<void> sound();
  std::unique_ptr<Row> find(std::string_view key);
  Expected<void> change(std::string_view key, const std::string* value);
  std::uint64_t used_bytes() const;

  std::unique_ptr<SQLite::Database> file_;
  StoreLimits limits_;
  bool damaged_ = false;  // some row was, when all were read last
};

}  // namespace race::database
