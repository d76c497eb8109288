#include "server/store/documents.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <filesystem>

#include "core/rcm/constraints.h"
#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/value/json.h"
#include "server/store/files.h"

namespace race::server {
namespace {

constexpr const char* kSetUp =
    "PRAGMA journal_mode = WAL;"
    "PRAGMA synchronous = FULL;"
    "CREATE TABLE IF NOT EXISTS document (name TEXT PRIMARY KEY, revision INTEGER NOT NULL, text TEXT NOT NULL);";

// `user_version` of the file; 0: of a version of the program that gave no ids.
constexpr int kVersion = 1;

std::vector<Error> one(ErrorCode code, std::string message, std::string path) {
  return {Error{code, std::move(message), std::move(path)}};
}

tl::unexpected<std::vector<Error>> failure(const std::string& what, const SQLite::Exception& exception) {
  return tl::unexpected(one(ErrorCode::io, what + ": " + exception.what(), ""));
}

/// What has the right shape in a stored text.
Expected<rcm::Draft> read_draft(const std::string& text) {
  const auto json = parse_json(text, JsonLimits{.keep_out_of_range = true});
  if (!json) return tl::unexpected(json.error());
  return rcm::read_draft(*json);
}

/// Without ids that are none: texts of a version of the program that had no ids may say anything in their place.
std::optional<rcm::Document> read_without_bad_ids(const std::string& text) {
  auto draft = read_draft(text);
  if (!draft || draft->errors.size() > draft->bad_ids || !rcm::violations(draft->document).empty()) return {};
  return std::move(draft->document);
}

}  // namespace

Documents::Documents(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
Documents::~Documents() = default;

Expected<std::unique_ptr<Documents>> Documents::open(const std::string& path) {
  try {
    auto file = std::make_unique<SQLite::Database>(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, 10'000);
    file->exec(kSetUp);
    std::unique_ptr<Documents> documents(new Documents(std::move(file)));
    documents->migrate();
    return documents;
  } catch (const SQLite::Exception& failure) {
    return unexpected(ErrorCode::io, std::string("cannot open the store: ") + failure.what(), path);
  }
}

std::vector<Documents::Row> Documents::rows(const char* where, const std::string& name) {
  SQLite::Statement select(*file_, std::string("SELECT name, revision, text FROM document ") + where);
  if (select.getBindParameterCount() > 0) select.bind(1, name);
  std::vector<Row> found;
  while (select.executeStep())
    found.push_back({select.getColumn(0), select.getColumn(2), select.getColumn(1).getInt64()});
  return found;
}

std::vector<Documents::Row> Documents::row(const std::string& name) { return rows("WHERE name = ?", name); }

void Documents::write(const Row& row) {
  SQLite::Statement insert(*file_, "INSERT OR REPLACE INTO document VALUES (?, ?, ?)");
  insert.bind(1, row.name);
  insert.bind(2, row.revision);
  insert.bind(3, row.text);
  insert.exec();
}

Checked<StoredDocument> Documents::read(const Row& row) {
  auto document = rcm::read_document_text(row.text);
  if (!document) return tl::unexpected(std::move(document).error());
  return StoredDocument{row.name, row.revision, std::move(*document)};
}

// Gives `document` ids, as the next revision of the row, if there is one.
void Documents::give_ids_after(const std::vector<Row>& old, rcm::Document& document) {
  if (old.empty()) return rcm::give_ids(document);
  const auto previous = read_draft(old.front().text);  // it may have violations: ids are kept all the same
  rcm::give_ids(document, previous ? &previous->document : nullptr);
}

// Stores what an older version of the program stored as this one does. What cannot be read, or not again, stays.
void Documents::migrate() {
  const services::MutexLock lock(mutex_);
  SQLite::Transaction transaction(*file_);
  if (file_->execAndGet("PRAGMA user_version").getInt() >= kVersion) return;
  for (const Row& row : rows("", "")) {
    auto document = read_without_bad_ids(row.text);
    if (!document) continue;  // see list()
    rcm::give_ids(*document);
    if (auto text = rcm::write_document_text(*document)) write({row.name, std::move(*text), row.revision});
  }
  file_->exec("PRAGMA user_version = " + std::to_string(kVersion));
  transaction.commit();
}

Checked<std::vector<StoredDocument>> Documents::list() try {
  const services::MutexLock lock(mutex_);
  std::vector<StoredDocument> all;
  // A document that an older version of the program stored may be invalid now; it is left out and stays in the file.
  // get() says what is wrong with it.
  for (const Row& row : rows("ORDER BY name", ""))
    if (auto document = read(row)) all.push_back(std::move(*document));
  return all;
} catch (const SQLite::Exception& exception) {
  return failure("cannot read documents", exception);
}

Checked<StoredDocument> Documents::get(const std::string& name) try {
  const services::MutexLock lock(mutex_);
  const auto found = row(name);
  if (found.empty()) return tl::unexpected(one(ErrorCode::not_found, "there is no document of this name", name));
  return read(found.front());
} catch (const SQLite::Exception& exception) {
  return failure("cannot read documents", exception);
}

Checked<StoredDocument> Documents::put(const std::string& name, std::string_view text) try {
  if (!rcm::is_id(name))
    return tl::unexpected(one(ErrorCode::name, "a document's name is 1 to 64 of A-Z a-z 0-9 _ -", name));
  auto document = rcm::read_document_text(text);
  if (!document) return tl::unexpected(std::move(document).error());
  const services::MutexLock lock(mutex_);
  const auto old = row(name);
  give_ids_after(old, *document);
  auto next_text = rcm::write_document_text(*document);
  if (!next_text) return tl::unexpected(std::vector<Error>{std::move(next_text).error()});
  Row next{name, std::move(*next_text), old.empty() ? 1 : old.front().revision};
  if (!old.empty() && old.front().text != next.text) ++next.revision;
  write(next);
  return StoredDocument{name, next.revision, std::move(*document)};
} catch (const SQLite::Exception& exception) {
  return failure("cannot store " + name, exception);
}

Checked<void> Documents::put_demo(const std::string& folder) {
  namespace fs = std::filesystem;
  constexpr std::string_view kEnding = ".rcm.json";
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::string name = entry.path().filename();
    if (!name.ends_with(kEnding)) continue;
    name.resize(name.size() - kEnding.size());
    auto text = read_file(entry.path());
    auto document =
        text ? rcm::read_document_text(*text) : Checked<rcm::Document>(tl::unexpect, std::vector<Error>{text.error()});
    auto put =
        document ? put_unchanged(name, std::move(*document)) : Checked<void>(tl::unexpect, std::move(document).error());
    if (!put) {
      for (Error& each : put.error()) each.path = entry.path().string() + ": " + each.path;
      return put;
    }
  }
  return {};
}

// Stores the document unless somebody has changed it since it was put.
Checked<void> Documents::put_unchanged(const std::string& name, rcm::Document document) try {
  const services::MutexLock lock(mutex_);
  const auto old = row(name);
  if (!old.empty() && old.front().revision > 1) return {};
  give_ids_after(old, document);
  auto text = rcm::write_document_text(document);
  if (!text) return tl::unexpected(std::vector<Error>{std::move(text).error()});
  write({name, std::move(*text), 1});
  return {};
} catch (const SQLite::Exception& exception) {
  return failure("cannot store " + name, exception);
}

}  // namespace race::server
