#include "server/store/document_breakpoints.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "core/language/primitives/utf8.h"
#include "core/value/json.h"
#include "server/store/digest_column.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

sqlite::Digest digest_of(const std::string& document, const std::string& author, std::int64_t number,
                         const std::string& text) {
  return sqlite::sha256_of({"breakpoints", document, author, std::to_string(number), text});
}

Expected<void> check_document(SQLite::Database& file, const std::string& document) {
  SQLite::Statement select(file, "SELECT 1 FROM document WHERE name = ?");
  select.bind(1, document);
  if (select.executeStep()) return {};
  return unexpected(ErrorCode::not_found, "there is no document of this name", document);
}

void remove_kept(SQLite::Database& file, const std::string& document, const std::string& author) {
  SQLite::Statement remove(file, "DELETE FROM document_breakpoints WHERE document = ? AND author = ?");
  remove.bind(1, document);
  remove.bind(2, author);
  remove.exec();
}

std::int64_t next_kept_number(SQLite::Database& file, const std::string& document) {
  SQLite::Statement select(file, "SELECT coalesce(max(number), 0) + 1 FROM document_breakpoints WHERE document = ?");
  select.bind(1, document);
  select.executeStep();
  return select.getColumn(0).getInt64();
}

void insert_kept(SQLite::Database& file, const std::string& document, const std::string& author,
                 const List& breakpoints) {
  const std::int64_t number = next_kept_number(file, document);
  const std::string text = to_json(Value(breakpoints));
  SQLite::Statement insert(file, "INSERT INTO document_breakpoints VALUES (?, ?, ?, ?, ?)");
  insert.bind(1, document);
  insert.bind(2, author);
  insert.bind(3, number);
  insert.bind(4, text);
  bind_digest(insert, 5, digest_of(document, author, number, text));
  insert.exec();
}

void forget_oldest_people(SQLite::Database& file, const std::string& document) {
  SQLite::Statement forget(file,
                           "DELETE FROM document_breakpoints WHERE document = ?1 AND author NOT IN (SELECT author FROM"
                           " document_breakpoints WHERE document = ?1 ORDER BY number DESC LIMIT ?2)");
  forget.bind(1, document);
  forget.bind(2, static_cast<std::int64_t>(DocumentBreakpoints::kMostPeople));
  forget.exec();
}

}  // namespace

DocumentBreakpoints::DocumentBreakpoints(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
DocumentBreakpoints::~DocumentBreakpoints() = default;

Expected<std::unique_ptr<DocumentBreakpoints>> DocumentBreakpoints::open(const std::string& path) try {
  return std::unique_ptr<DocumentBreakpoints>(new DocumentBreakpoints(sqlite::open(path)));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the breakpoints"));
}

Expected<void> DocumentBreakpoints::check_author(const std::string& author) {
  if (author.empty()) return unexpected(ErrorCode::missing, "the query must say whose breakpoints", "author");
  if (language::utf8::length(author) <= kLongestName) return {};
  return unexpected(ErrorCode::too_large, "has more than " + std::to_string(kLongestName) + " characters", "author");
}

Expected<List> DocumentBreakpoints::get(const std::string& document, const std::string& author) try {
  if (auto fits = check_author(author); !fits) return tl::unexpected(std::move(fits).error());
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_,
                           "SELECT number, text, digest FROM document_breakpoints WHERE document = ? AND author = ?");
  select.bind(1, document);
  select.bind(2, author);
  if (!select.executeStep()) return List();
  const std::string text = select.getColumn(1);
  const auto value = parse_json(text);
  if (digest_in(select, 2) != digest_of(document, author, select.getColumn(0).getInt64(), text) || !value ||
      !value->is_list())
    return unexpected(ErrorCode::corrupt, "the breakpoints of `" + author + "` are damaged", document);
  return value->as_list();
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot read the breakpoints"));
}

Expected<void> DocumentBreakpoints::set(const std::string& document, const std::string& author,
                                        const List& breakpoints) try {
  if (auto fits = check_author(author); !fits) return fits;
  if (breakpoints.size() > kMost)
    return unexpected(ErrorCode::too_large, "there may be " + std::to_string(kMost) + " breakpoints", "breakpoints");
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  if (auto found = check_document(*file_, document); !found) return found;
  remove_kept(*file_, document, author);
  if (!breakpoints.empty()) insert_kept(*file_, document, author, breakpoints);
  forget_oldest_people(*file_, document);
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store the breakpoints"));
}

}  // namespace race::server
