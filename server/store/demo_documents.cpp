// The documents of the server's demo: put when the server begins, until somebody changes them.
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <filesystem>

#include "server/store/document_removal.h"
#include "server/store/documents.h"
#include "server/store/files.h"
#include "services/sqlite/file.h"

namespace race::server {

Checked<void> Documents::put_demo(const std::string& folder, std::int64_t now_ms) {
  namespace fs = std::filesystem;
  constexpr std::string_view kEnding = ".rcm.json";
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::string name = entry.path().filename();
    if (!name.ends_with(kEnding)) continue;
    name.resize(name.size() - kEnding.size());
    if (auto put = put_demo_file(name, entry.path(), now_ms); !put) {
      for (Error& each : put.error()) each.path = entry.path().string() + ": " + each.path;
      return put;
    }
  }
  return {};
}

Checked<void> Documents::put_demo_file(const std::string& name, const std::string& path, std::int64_t now_ms) try {
  const auto failed = [](Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); };
  const auto text = read_file(path);
  if (!text) return failed(text.error());
  auto document = read_document_or_draft(*text);
  if (!document) return tl::unexpected(std::move(document).error());
  if (!document->errors.empty()) return tl::unexpected(std::move(document->errors));
  const services::MutexLock lock(mutex_);
  const auto old = head(name);
  if (!old && old.error().code == ErrorCode::corrupt) return {};  // it stays as it is; others are named
  if (!old) return failed(old.error());
  if (!has_only_demo(*file_, name)) return {};
  const auto removed = last_removed(*file_, name);
  if (!removed) return failed(removed.error());
  if (!*old && *removed > 0) return {};  // somebody has removed it
  auto next = next_text(*document, *text, *old ? (*old)->text : "");
  if (!next) return failed(std::move(next).error());
  if (*old && (*old)->text == *next) return {};
  const Origin demo{Origin::Kind::demo};
  const auto put = append({{name, 1, {"", "", now_ms}, demo, 0, doc_of(document->document)}, std::move(*next)});
  if (!put) return failed(put.error());
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(std::vector<Error>{sqlite::error_of(exception, "cannot store " + name)});
}

}  // namespace race::server
