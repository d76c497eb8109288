#include "server/commands/document_file.h"

#include <filesystem>

#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/value/json.h"
#include "server/store/files.h"
#include "services/sqlite/digest.h"

namespace race::server {
namespace {

constexpr std::string_view kEnding = ".rcm.json";

}  // namespace

std::string document_file_name(std::string_view name) { return std::string(name) + std::string(kEnding); }

Expected<std::string> document_name_of(const std::string& path) {
  const std::string file = std::filesystem::path(path).filename();
  std::string name = file.ends_with(kEnding) ? file.substr(0, file.size() - kEnding.size()) : "";
  if (rcm::is_id(name)) return name;  // names of documents and ids have the same form
  return unexpected(ErrorCode::name, "the file of a document is NAME.rcm.json, with 1 to 64 of A-Z a-z 0-9 _ -", path);
}

std::string document_text(const Value& document) {
  const rcm::Draft draft = rcm::read_draft(document);
  if (draft.errors.empty() && draft.has_root)
    if (auto text = rcm::write_document_text(draft.document)) return std::move(*text);
  return to_json(document, 2) + '\n';
}

Expected<DocumentFile> read_document_file(const std::string& path) {
  DocumentFile file;
  ASSIGN_OR_RETURN(file.bytes, read_file(path));
  file.document = parse_json(file.bytes);
  if (!file.document) file.document.error().path = path;
  file.text = file.document ? document_text(*file.document) : file.bytes;
  return file;
}

std::string hash_of(std::string_view text) { return sqlite::hex(sqlite::sha256(text)); }

}  // namespace race::server
