#include "server/store/document_migrations.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <optional>

#include "core/rcm/constraints.h"
#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/value/error_list.h"
#include "core/value/json.h"
#include "server/store/document_text.h"
#include "server/store/revision_rows.h"

namespace race::server {
namespace {

/// Without ids that are none: texts of a version of the program that had no ids may say anything in their place.
std::optional<rcm::Document> read_without_bad_ids(const std::string& text) {
  const auto json = parse_json(text, JsonLimits{.keep_out_of_range = true});
  if (!json) return {};
  rcm::Draft draft = rcm::read_draft(*json);
  if (is_full(draft.errors) || draft.errors.size() > draft.bad_ids || !rcm::violations(draft.document).empty())
    return {};
  return std::move(draft.document);
}

std::optional<std::string> with_ids(const std::string& text) {
  auto document = read_without_bad_ids(text);
  if (!document) return {};
  rcm::give_ids(*document);
  auto next = rcm::write_document_text(*document);
  if (!next) return {};
  return std::move(*next);
}

Revision describe(const std::string& text) {
  Revision out;
  out.origin.kind = Origin::Kind::older;
  const auto read = read_document_or_draft(text);
  out.errors = static_cast<std::int64_t>(read ? read->errors.size() : read.error().size());
  if (read) out.doc = doc_of(read->document);
  return out;
}

}  // namespace

void give_document_ids(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE IF NOT EXISTS document (name TEXT PRIMARY KEY, revision INTEGER NOT NULL, text TEXT NOT NULL)");
  SQLite::Statement select(file, "SELECT rowid, text FROM document");
  SQLite::Statement update(file, "UPDATE document SET text = ? WHERE rowid = ?");
  while (select.executeStep()) {
    const auto text = with_ids(select.getColumn(1));
    if (!text) continue;
    update.bind(1, *text);
    update.bind(2, select.getColumn(0).getInt64());
    update.exec();
    update.reset();
  }
}

// document.first, last: the numbers of its revisions, without gaps; revision.time: milliseconds since 1970, 0: not
// known; origin: Origin::Kind, with from_document and from_revision; text_digest: sha256(text). The digest of a
// revision is of all fields but `text`, so that a list reads no texts.
void add_revisions(SQLite::Database& file) {
  file.exec(
      "ALTER TABLE document RENAME TO old_document;"
      "CREATE TABLE document (name TEXT PRIMARY KEY, first INTEGER NOT NULL, last INTEGER NOT NULL,"
      " digest BLOB NOT NULL) WITHOUT ROWID;"
      "CREATE TABLE revision (document TEXT NOT NULL, number INTEGER NOT NULL, author TEXT NOT NULL,"
      " time INTEGER NOT NULL, message TEXT NOT NULL, origin TEXT NOT NULL, from_document TEXT NOT NULL,"
      " from_revision INTEGER NOT NULL, errors INTEGER NOT NULL, doc TEXT NOT NULL, text_digest BLOB NOT NULL,"
      " digest BLOB NOT NULL, text TEXT NOT NULL, PRIMARY KEY (document, number)) WITHOUT ROWID;");
  {
    SQLite::Statement select(file, "SELECT name, revision, text FROM old_document");
    while (select.executeStep()) {
      const std::string text = select.getColumn(2);
      Revision revision = describe(text);
      revision.document = select.getColumn(0).getString();
      revision.number = select.getColumn(1).getInt64();
      add_revision(file, {revision, text}, revision.number);
    }
  }
  file.exec("DROP TABLE old_document");
}

}  // namespace race::server
