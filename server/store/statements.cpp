#include "server/store/statements.h"

#include <SQLiteCpp/Statement.h>

#include <string>
#include <tuple>

namespace race::server {

Statements::Statements(SQLite::Database& file) : file_(file) {}
Statements::~Statements() = default;

Statements::Use Statements::use(std::string_view sql) {
  auto& prepared = prepared_[sql];
  if (!prepared) prepared = std::make_unique<SQLite::Statement>(file_, std::string(sql));
  return Use(*prepared);
}

// What reset() returns was thrown when the statement failed.
Statements::Use::~Use() {
  std::ignore = statement_.tryReset();
  statement_.clearBindings();
}

}  // namespace race::server
