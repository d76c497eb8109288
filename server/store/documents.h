// Documents: the tasks that the server keeps, by name, in one SQLite file. Only documents without violations get in.
// Every element of what is kept has an id (core/rcm/ids.h).
//
// Threads: any; one at a time inside.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/rcm/model.h"
#include "core/value/expected.h"
#include "services/mutex.h"

namespace SQLite {
class Database;
}

namespace race::server {

struct StoredDocument {
  std::string name;
  std::int64_t revision = 1;  // counts changes
  rcm::Document document;
};

class Documents {
 public:
  ~Documents();

  /// Opens the file or makes it. Documents that an older version of the program stored get ids, also in place of a
  /// `meta.id` that is none, and today's form; they keep their revision, as nobody changed them. What has other
  /// violations, or would be too large or too deep, stays as it is. Error `io`.
  static Expected<std::unique_ptr<Documents>> open(const std::string& path);

  /// In order of name. Error of all: `io`.
  Checked<std::vector<StoredDocument>> list() EXCLUDES(mutex_);
  /// `not_found`: there is none.
  Checked<StoredDocument> get(const std::string& name) EXCLUDES(mutex_);
  /// Checks and stores a text and gives its elements ids, where they are missing those of the last revision. A document
  /// that is the same then keeps its revision. Errors: every violation; `name`: not 1 to 64 of A-Z, a-z, 0-9, `_`, `-`;
  /// `too_large`, `too_deep`: with ids it could not be read again.
  Checked<StoredDocument> put(const std::string& name, std::string_view text) EXCLUDES(mutex_);
  /// Puts every *.rcm.json of `folder` that is not there or that nobody has changed since it was put. Errors name the
  /// file.
  Checked<void> put_demo(const std::string& folder);

 private:
  struct Row {
    std::string name, text;
    std::int64_t revision;
  };
  explicit Documents(std::unique_ptr<SQLite::Database> file);
  std::vector<Row> rows(const char* where, const std::string& name) REQUIRES(mutex_);
  std::vector<Row> row(const std::string& name) REQUIRES(mutex_);
  void migrate() EXCLUDES(mutex_);
  void write(const Row& row) REQUIRES(mutex_);
  Checked<void> put_unchanged(const std::string& name, rcm::Document document) EXCLUDES(mutex_);
  static Checked<StoredDocument> read(const Row& row);
  static void give_ids_after(const std::vector<Row>& old, rcm::Document& document);

  services::Mutex mutex_;
  const std::unique_ptr<SQLite::Database> file_ PT_GUARDED_BY(mutex_);
};

}  // namespace race::server
