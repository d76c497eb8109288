#include "server/store/documents.h"

#include <sqlite3.h>

#include <algorithm>
#include <filesystem>

#include "core/rcm/document.h"
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

}  // namespace

void Documents::Close::operator()(sqlite3* file) const { sqlite3_close_v2(file); }

std::vector<Error> Documents::failure(const std::string& what) const {
  return one(ErrorCode::io, what + ": " + sqlite3_errmsg(file_.get()), "");
}

Expected<std::unique_ptr<Documents>> Documents::open(const std::string& path) {
  sqlite3* file = nullptr;
  const int opened = sqlite3_open_v2(path.c_str(), &file, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  std::unique_ptr<Documents> documents(new Documents(file));
  if (opened != SQLITE_OK || sqlite3_exec(file, kSetUp, nullptr, nullptr, nullptr) != SQLITE_OK)
    return unexpected(ErrorCode::io, documents->failure("cannot open the store").front().message, path);
  return documents;
}

Checked<std::vector<Documents::Row>> Documents::rows(const char* where, const std::string& name) {
  const std::string sql = std::string("SELECT name, revision, text FROM document ") + where;
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(file_.get(), sql.c_str(), -1, &raw, nullptr);
  const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> select(raw, sqlite3_finalize);
  if (sqlite3_bind_parameter_count(raw) > 0) sqlite3_bind_text(raw, 1, name.c_str(), -1, SQLITE_TRANSIENT);
  const auto text = [&](int column) { return reinterpret_cast<const char*>(sqlite3_column_text(raw, column)); };
  std::vector<Row> found;
  int status = SQLITE_DONE;
  while ((status = sqlite3_step(raw)) == SQLITE_ROW) found.push_back({text(0), text(2), sqlite3_column_int64(raw, 1)});
  if (status != SQLITE_DONE) return tl::unexpected(failure("cannot read documents"));
  return found;
}

Checked<void> Documents::write(const Row& row) {
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(file_.get(), "INSERT OR REPLACE INTO document VALUES (?, ?, ?)", -1, &raw, nullptr);
  const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> insert(raw, sqlite3_finalize);
  sqlite3_bind_text(raw, 1, row.name.c_str(), -1, SQLITE_TRANSIENT);
  sqlite3_bind_int64(raw, 2, row.revision);
  sqlite3_bind_text(raw, 3, row.text.c_str(), -1, SQLITE_TRANSIENT);
  if (sqlite3_step(raw) != SQLITE_DONE) return tl::unexpected(failure("cannot store " + row.name));
  return {};
}

Checked<StoredDocument> Documents::read(const Row& row) {
  auto document = rcm::read_document_text(row.text);
  if (!document) return tl::unexpected(std::move(document).error());
  return StoredDocument{row.name, row.revision, std::move(*document)};
}

Checked<std::vector<StoredDocument>> Documents::list() {
  const std::lock_guard lock(mutex_);
  auto found = rows("ORDER BY name", "");
  if (!found) return tl::unexpected(std::move(found).error());
  std::vector<StoredDocument> all;
  // A document of an older version of the format may not be one any more; it is left out and stays in the file.
  for (const Row& row : *found)
    if (auto document = read(row)) all.push_back(std::move(*document));
  return all;
}

Checked<StoredDocument> Documents::get(const std::string& name) {
  const std::lock_guard lock(mutex_);
  auto found = rows("WHERE name = ?", name);
  if (!found) return tl::unexpected(std::move(found).error());
  if (found->empty()) return tl::unexpected(one(ErrorCode::not_found, "there is no document of this name", name));
  return read(found->front());
}

Checked<StoredDocument> Documents::put(const std::string& name, std::string_view text) {
  if (!is_document_name(name))
    return tl::unexpected(one(ErrorCode::name, "a document's name is 1 to 64 of A-Z a-z 0-9 _ -", name));
  auto document = rcm::read_document_text(text);
  if (!document) return tl::unexpected(std::move(document).error());
  const std::lock_guard lock(mutex_);
  auto old = rows("WHERE name = ?", name);
  if (!old) return tl::unexpected(std::move(old).error());
  Row row{name, rcm::format_document(*document), old->empty() ? 1 : old->front().revision};
  if (!old->empty() && old->front().text != row.text) ++row.revision;
  if (auto written = write(row); !written) return tl::unexpected(std::move(written).error());
  return StoredDocument{name, row.revision, std::move(*document)};
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
    if (!document) {
      for (Error& each : document.error()) each.path = entry.path().string() + ": " + each.path;
      return tl::unexpected(std::move(document).error());
    }
    const std::lock_guard lock(mutex_);
    auto old = rows("WHERE name = ?", name);
    if (!old) return tl::unexpected(std::move(old).error());
    if (!old->empty() && old->front().revision > 1) continue;
    if (auto put = write({name, rcm::format_document(*document), 1}); !put) return put;
  }
  return {};
}

}  // namespace race::server
