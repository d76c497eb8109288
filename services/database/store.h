// Store: values by key in one SQLite file. Each change is durable when the function returns.
//
// Threads: one at a time.
#pragma once

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

class Store {
 public:
  static constexpr std::size_t kKeyBytes = 1000;
  static constexpr std::size_t kValueBytes = 16 * 1024 * 1024;  // of its JSON
  static constexpr std::size_t kValueDepth = 64;

  /// Opens the file, or makes it; ":memory:" is a store in memory. Errors: `io`.
  static Expected<Store> open(const std::string& path);
  Store(Store&&) noexcept;
  ~Store();

  /// Errors of all: `io`. `not_found`: no such key.
  Expected<Value> get(std::string_view key);
  /// Stores `value` under `key`, over an old one. Errors: `out_of_range` (an empty or long key), `too_large`,
  /// `too_deep`.
  Expected<void> put(std::string_view key, const Value& value);
  /// `not_found`: no such key.
  Expected<void> remove(std::string_view key);
  /// The keys that begin with `prefix`, in order of their bytes.
  Expected<std::vector<std::string>> keys(std::string_view prefix);

 private:
  explicit Store(std::unique_ptr<SQLite::Database> file);

  std::unique_ptr<SQLite::Database> file_;
};

}  // namespace race::database
