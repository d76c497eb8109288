// Documents: the tasks that the server keeps, by name, in one SQLite file. Only documents without violations get in.
//
// Threads: any; one at a time inside.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/rcm/model.h"
#include "core/value/expected.h"

struct sqlite3;

namespace race::server {

struct StoredDocument {
  std::string name;
  std::int64_t revision = 1;  // counts changes
  rcm::Document document;
};

class Documents {
 public:
  /// Opens the file or makes it. Error `io`.
  static Expected<std::unique_ptr<Documents>> open(const std::string& path);

  /// In order of name. Error of all: `io`.
  Checked<std::vector<StoredDocument>> list();
  /// `not_found`: there is none.
  Checked<StoredDocument> get(const std::string& name);
  /// Checks and stores a text; a document that is the same keeps its revision. Errors: every violation; `name`: not 1
  /// to 64 of A-Z, a-z, 0-9, `_`, `-`.
  Checked<StoredDocument> put(const std::string& name, std::string_view text);
  /// Puts every *.rcm.json of `folder` that is not there or that nobody has changed since it was put. Errors name the
  /// file.
  Checked<void> put_demo(const std::string& folder);

 private:
  struct Close {
    void operator()(sqlite3* file) const;
  };
  struct Row {
    std::string name, text;
    std::int64_t revision;
  };
  explicit Documents(sqlite3* file) : file_(file) {}
  Checked<std::vector<Row>> rows(const char* where, const std::string& name);
  Checked<void> write(const Row& row);
  std::vector<Error> failure(const std::string& what) const;
  static Checked<StoredDocument> read(const Row& row);

  std::mutex mutex_;
  std::unique_ptr<sqlite3, Close> file_;
};

}  // namespace race::server
