#include "server/store/revision_rows.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <array>
#include <utility>

#include "server/store/digest_column.h"
#include "server/store/document_removal.h"
#include "server/store/revision_text.h"
#include "services/sqlite/digest.h"

namespace race::server {
namespace {

constexpr std::array kKinds = {Origin::Kind::put,  Origin::Kind::restore, Origin::Kind::branch,
                               Origin::Kind::demo, Origin::Kind::older,   Origin::Kind::edit,
                               Origin::Kind::undo, Origin::Kind::redo,    Origin::Kind::proposal};

// All columns of `revision` but `text`.
constexpr const char* kColumns =
    "revision.document, revision.number, revision.author, revision.time, revision.message, revision.origin,"
    " revision.from_document, revision.from_revision, revision.errors, revision.doc, revision.text_digest,"
    " revision.digest";
constexpr int kColumnCount = 12;

tl::unexpected<Error> damaged_entry(const std::string& name) {
  return unexpected(ErrorCode::corrupt, "the entry of the document `" + name + "` is damaged or lost", name);
}

sqlite::Digest digest_of(const std::string& name, RevisionRange range) {
  return sqlite::sha256_of({name, std::to_string(range.first), std::to_string(range.last)});
}

/// What the column `from_document` says: of a proposal, who has made it.
const std::string& source_of(const Origin& origin) {
  return origin.kind == Origin::Kind::proposal ? origin.author : origin.document;
}

sqlite::Digest digest_of(const Revision& revision, std::string_view text_digest) {
  const auto& [document, number, change, origin, errors, doc] = revision;
  return sqlite::sha256_of({document, std::to_string(number), change.author, std::to_string(change.time_ms),
                            change.message, name(origin.kind), source_of(origin), std::to_string(origin.revision),
                            std::to_string(errors), doc, text_digest});
}

struct Row {
  Revision revision;
  std::string text_digest;
  bool is_sound = false;
};

/// Of kColumns from column `first` on.
Row read_entry(SQLite::Statement& select, int first = 0) {
  const auto text = [&](int column) { return select.getColumn(first + column).getString(); };
  const auto number = [&](int column) { return select.getColumn(first + column).getInt64(); };
  Row row;
  const std::string kind = text(5);
  const auto known = std::ranges::find(kKinds, kind, [](Origin::Kind each) { return std::string(name(each)); });
  row.revision = {text(0),   number(1), {text(2), text(4), number(3)}, {Origin::Kind::put, text(6), number(7)},
                  number(8), text(9)};
  row.text_digest = text(10);
  if (known == kKinds.end()) return row;
  Origin& origin = row.revision.origin;
  origin.kind = *known;
  if (*known == Origin::Kind::proposal) std::swap(origin.author, origin.document);
  row.is_sound = sqlite::bytes(digest_of(row.revision, row.text_digest)) == text(11);
  return row;
}

/// A row with its column `text`, which is empty where the text is that of a chain (revision_text.h).
struct StoredRow {
  Row row;
  std::string text;
  bool has_its_text() const { return sqlite::bytes(sqlite::sha256(text)) == row.text_digest; }
};

Expected<StoredRow> read_stored(SQLite::Database& file, const std::string& name, std::int64_t number) {
  SQLite::Statement select(
      file, std::string("SELECT ") + kColumns + ", revision.text FROM revision WHERE document = ? AND number = ?");
  select.bind(1, name);
  select.bind(2, number);
  if (!select.executeStep()) return damaged_revision(name, number, "lost");
  StoredRow stored{read_entry(select), select.getColumn(kColumnCount)};
  if (!stored.row.is_sound) return damaged_revision(name, number, "damaged");
  return stored;
}

/// Documents that have revisions but no entry, with names from after `after` to `to` (empty: all). What a removal has
/// left is none. Looks for each name once.
std::vector<std::string> find_lost_entries(SQLite::Database& file, const std::string& after, const std::string& to) {
  SQLite::Statement select(
      file,
      "WITH RECURSIVE each(name) AS (SELECT (SELECT min(document) FROM revision WHERE document > ?1)"
      "  UNION ALL SELECT (SELECT min(document) FROM revision WHERE document > name) FROM each"
      "  WHERE name IS NOT NULL AND (?2 = '' OR name <= ?2))"
      " SELECT name FROM each WHERE name IS NOT NULL AND (?2 = '' OR name <= ?2)"
      "  AND name NOT IN (SELECT name FROM document) AND (SELECT max(number) FROM revision WHERE document = each.name)"
      "  > coalesce((SELECT last FROM removed_document WHERE name = each.name), 0)");
  select.bind(1, after);
  select.bind(2, to);
  std::vector<std::string> lost;
  while (select.executeStep()) lost.push_back(select.getColumn(0).getString());
  return lost;
}

/// The last revision of the document at which `select` stands (list_heads).
Expected<Revision> read_head(SQLite::Statement& select) {
  const std::string name = select.getColumn(kColumnCount);
  const RevisionRange range{select.getColumn(kColumnCount + 1).getInt64(),
                            select.getColumn(kColumnCount + 2).getInt64()};
  if (sqlite::bytes(digest_of(name, range)) != select.getColumn(kColumnCount + 3).getString())
    return damaged_entry(name);
  Row row = read_entry(select);
  if (!row.is_sound) return damaged_revision(name, range.last, "damaged or lost");
  return std::move(row.revision);
}

}  // namespace

const char* name(Origin::Kind kind) {
  switch (kind) {
    case Origin::Kind::put:
      return "put";
    case Origin::Kind::restore:
      return "restore";
    case Origin::Kind::branch:
      return "branch";
    case Origin::Kind::demo:
      return "demo";
    case Origin::Kind::older:
      return "older";
    case Origin::Kind::edit:
      return "edit";
    case Origin::Kind::undo:
      return "undo";
    case Origin::Kind::redo:
      return "redo";
    case Origin::Kind::proposal:
      return "proposal";
  }
  return "";
}

tl::unexpected<Error> damaged_revision(const std::string& document, std::int64_t number, const char* what) {
  const std::string text = std::to_string(number);
  return unexpected(ErrorCode::corrupt, "revision " + text + " of the document `" + document + "` is " + what,
                    document + "/revisions/" + text);
}

Expected<std::optional<RevisionRange>> find_range(SQLite::Database& file, const std::string& name) {
  SQLite::Statement select(file, "SELECT first, last, digest FROM document WHERE name = ?");
  select.bind(1, name);
  if (select.executeStep()) {
    const RevisionRange range{select.getColumn(0).getInt64(), select.getColumn(1).getInt64()};
    if (sqlite::bytes(digest_of(name, range)) != select.getColumn(2).getString()) return damaged_entry(name);
    return range;
  }
  const std::int64_t largest = largest_number(file, name);
  if (largest == 0) return std::nullopt;
  ASSIGN_OR_RETURN(const std::int64_t removed, last_removed(file, name));
  if (largest > removed) return damaged_entry(name);
  return std::nullopt;
}

Expected<RevisionText> read_revision(SQLite::Database& file, const std::string& name, std::int64_t number) {
  ASSIGN_OR_RETURN(StoredRow stored, read_stored(file, name, number));
  if (stored.text.empty() && is_edit(stored.row.revision.origin.kind)) {
    ASSIGN_OR_RETURN(const std::int64_t depth, chain_depth(file, name, number));
    ASSIGN_OR_RETURN(const StoredRow base, read_stored(file, name, number - depth));
    if (!base.has_its_text()) return damaged_revision(name, number - depth, "damaged");
    ASSIGN_OR_RETURN(stored.text, text_after(file, name, {number - depth + 1, number}, base.text));
  }
  if (!stored.has_its_text()) return damaged_revision(name, number, "damaged");
  return RevisionText{std::move(stored.row.revision), std::move(stored.text)};
}

Expected<std::vector<Revision>> list_revisions(SQLite::Database& file, const std::string& name, RevisionRange range) {
  SQLite::Statement select(file, std::string("SELECT ") + kColumns +
                                     " FROM revision WHERE document = ? AND number BETWEEN ? AND ?"
                                     " ORDER BY number DESC");
  select.bind(1, name);
  select.bind(2, range.first);
  select.bind(3, range.last);
  std::vector<Revision> found;
  std::int64_t next = range.last;
  for (; select.executeStep(); --next) {
    Row row = read_entry(select);
    if (row.revision.number != next) return damaged_revision(name, next, "lost");
    if (!row.is_sound) return damaged_revision(name, next, "damaged");
    found.push_back(std::move(row.revision));
  }
  if (next >= range.first) return damaged_revision(name, next, "lost");
  return found;
}

DocumentHeads list_heads(SQLite::Database& file, const std::string& after, std::int64_t most) {
  DocumentHeads heads;
  SQLite::Statement select(file, std::string("SELECT ") + kColumns +
                                     ", document.name, document.first, document.last, document.digest"
                                     " FROM document LEFT JOIN revision ON revision.document = document.name"
                                     "  AND revision.number = document.last WHERE document.name > ?1"
                                     " ORDER BY document.name LIMIT ?2");
  select.bind(1, after);
  select.bind(2, most + 1);
  std::string last;
  for (std::int64_t i = 0; select.executeStep(); ++i) {
    if (i == most) {
      heads.next = last;
      break;
    }
    last = select.getColumn(kColumnCount).getString();
    if (auto head = read_head(select))
      heads.revisions.push_back(std::move(*head));
    else
      heads.damaged.push_back(std::move(head).error());
  }
  std::vector<Error> lost;
  for (const std::string& name : find_lost_entries(file, after, heads.next))
    lost.push_back(damaged_entry(name).value());
  heads.damaged.insert(heads.damaged.begin(), lost.begin(), lost.end());
  return heads;
}

std::int64_t count_documents(SQLite::Database& file) {
  return file.execAndGet("SELECT count(*) FROM document").getInt64();
}

bool has_only_demo(SQLite::Database& file, const std::string& name) {
  SQLite::Statement select(file,
                           "SELECT NOT EXISTS (SELECT 1 FROM revision WHERE document = ? AND origin <> 'demo'"
                           " AND NOT (origin = 'older' AND number = 1))");
  select.bind(1, name);
  return select.executeStep() && select.getColumn(0).getInt() != 0;
}

void add_revision(SQLite::Database& file, const RevisionText& added, std::int64_t first, const RevisionEdit* edit) {
  const auto& [revision, text] = added;
  const bool is_derived = edit && add_edit(file, added, *edit);
  const sqlite::Digest text_digest = sqlite::sha256(text);
  SQLite::Statement insert(file, "INSERT INTO revision VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(1, revision.document);
  insert.bind(2, revision.number);
  insert.bind(3, revision.change.author);
  insert.bind(4, revision.change.time_ms);
  insert.bind(5, revision.change.message);
  insert.bind(6, name(revision.origin.kind));
  insert.bind(7, source_of(revision.origin));
  insert.bind(8, revision.origin.revision);
  insert.bind(9, revision.errors);
  insert.bind(10, revision.doc);
  bind_digest(insert, 11, text_digest);
  bind_digest(insert, 12, digest_of(revision, sqlite::bytes(text_digest)));
  insert.bind(13, is_derived ? std::string() : text);
  insert.exec();
  SQLite::Statement entry(file, "INSERT OR REPLACE INTO document VALUES (?, ?, ?, ?)");
  entry.bind(1, revision.document);
  entry.bind(2, first);
  entry.bind(3, revision.number);
  bind_digest(entry, 4, digest_of(revision.document, {first, revision.number}));
  entry.exec();
}

}  // namespace race::server
