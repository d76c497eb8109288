#include "server/store/document_removal.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <vector>

#include "server/store/digest_column.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

sqlite::Digest digest_of(const std::string& name, std::int64_t last) {
  return sqlite::sha256_of({"removed", name, std::to_string(last)});
}

// `sql` has the name as ?1.
void execute(SQLite::Database& file, const char* sql, const std::string& name) {
  SQLite::Statement statement(file, sql);
  statement.bind(1, name);
  statement.exec();
}

}  // namespace

Expected<std::int64_t> last_removed(SQLite::Database& file, const std::string& name) {
  SQLite::Statement select(file, "SELECT last, digest FROM removed_document WHERE name = ?");
  select.bind(1, name);
  if (!select.executeStep()) return 0;
  const std::int64_t last = select.getColumn(0).getInt64();
  if (digest_in(select, 1) == digest_of(name, last)) return last;
  return unexpected(ErrorCode::corrupt, "what is known of the removed document `" + name + "` is damaged", name);
}

void begin_removal(SQLite::Database& file, const std::string& name, std::int64_t last) {
  execute(file, "DELETE FROM document WHERE name = ?1", name);
  execute(file, "DELETE FROM document_breakpoints WHERE document = ?1", name);
  execute(file, "DELETE FROM removed_document WHERE name = ?1", name);
  SQLite::Statement insert(file, "INSERT INTO removed_document (name, last, digest) VALUES (?, ?, ?)");
  insert.bind(1, name);
  insert.bind(2, last);
  bind_digest(insert, 3, digest_of(name, last));
  insert.exec();
  SQLite::Statement forget(file,
                           "DELETE FROM removed_document WHERE position <= (SELECT max(position) FROM removed_document)"
                           " - ?1 AND NOT EXISTS (SELECT 1 FROM revision WHERE document = name)");
  forget.bind(1, kMostRemoved);
  forget.exec();
}

std::int64_t largest_number(SQLite::Database& file, const std::string& name) {
  SQLite::Statement select(file, "SELECT coalesce(max(number), 0) FROM revision WHERE document = ?");
  select.bind(1, name);
  select.executeStep();
  return select.getColumn(0).getInt64();
}

bool remove_some(SQLite::Database& file, const std::string& name) {
  constexpr const char* kLast = "(SELECT last FROM removed_document WHERE name = ?1)";
  sqlite::WriteTransaction transaction(file);
  bool is_left = false;
  for (const char* table : {"revision_edit", "revision"}) {
    const std::string rows = std::string(" FROM ") + table + " WHERE document = ?1 AND number <= " + kLast;
    SQLite::Statement remove(file, "DELETE FROM " + std::string(table) +
                                       " WHERE document = ?1 AND number IN (SELECT number" + rows +
                                       " ORDER BY number LIMIT ?2)");
    remove.bind(1, name);
    remove.bind(2, kRevisionsAtOnce);
    is_left = remove.exec() == kRevisionsAtOnce || is_left;
  }
  transaction.commit();
  return is_left;
}

void finish_document_removals(SQLite::Database& file) {
  SQLite::Statement select(file,
                           "SELECT name FROM removed_document AS removed WHERE EXISTS (SELECT 1 FROM revision WHERE"
                           " document = name AND number <= removed.last) OR EXISTS (SELECT 1 FROM revision_edit WHERE"
                           " document = name AND number <= removed.last)");
  std::vector<std::string> names;
  while (select.executeStep()) names.push_back(select.getColumn(0).getString());
  select.reset();
  for (const std::string& name : names)
    while (remove_some(file, name)) {
    }
}

}  // namespace race::server
