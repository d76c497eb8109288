#include "server/store/documents.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <algorithm>
#include <filesystem>

#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "server/store/read_file.h"

namespace race::server {
namespace {

constexpr const char* kSetUp =
    "PRAGMA journal_mode = WAL;"
    "PRAGMA synchronous = FULL;"
    "CREATE TABLE IF NOT EXISTS document (name TEXT PRIMARY KEY, revision INTEGER NOT NULL, text TEXT NOT NULL);";

bool is_document_name(const std::string& name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= 64 && std::ranges::all_of(name, allowed);
}

std::vector<Error> one(ErrorCode code, std::string message, std::string path) {
  return {Error{code, std::move(message), std::move(path)}};
}

tl::unexpected<std::vector<Error>> failure(const std::string& what, const SQLite::Exception& exception) {
  return tl::unexpected(one(ErrorCode::io, what + ": " + exception.what(), ""));
}

}  // namespace

Documents::Documents(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
Documents::~Documents() = default;

Expected<std::unique_ptr<Documents>> Documents::open(const std::string& path) {
  try {
    auto file = std::make_unique<SQLite::Database>(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    file->exec(kSetUp);
    std::unique_ptr<Documents> documents(new Documents(std::move(file)));
    documents->renew();
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
  const auto previous = read(old.front());
  rcm::give_ids(document, previous ? &previous->document : nullptr);
}

// What is stored, as this version of the program stores it.
void Documents::renew() {
  const services::MutexLock lock(mutex_);
  SQLite::Transaction transaction(*file_);
  for (const Row& row : rows("", "")) {
    auto stored = read(row);
    if (!stored) continue;  // see list()
    rcm::give_ids(stored->document);
    auto text = rcm::write_document_text(stored->document);
    if (text && *text != row.text) write({row.name, std::move(*text), row.revision});
  }
  transaction.commit();
}

Checked<std::vector<StoredDocument>> Documents::list() try {
  const services::MutexLock lock(mutex_);
  std::vector<StoredDocument> all;
  // A document that an older version of the program stored may be invalid now; it is left out and stays in the file.
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
  if (!is_document_name(name))
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
