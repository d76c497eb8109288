#include "server/http/static_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "server/http/content_coding.h"
#include "server/http/field_list.h"
#include "server/http/refusal.h"
#include "server/store/files.h"
#include "services/sqlite/digest.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

std::string type_of(const fs::path& file) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kTypes = {{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".webmanifest", "application/manifest+json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".jpg", "image/jpeg"},
      {".ico", "image/x-icon"},
      {".woff2", "font/woff2"},
      {".wasm", "application/wasm"},
      {".map", "application/json"},
      {".urdf", "application/xml"},
      {".txt", "text/plain; charset=utf-8"},
  }};
  for (const auto& [extension, type] : kTypes)
    if (file.extension() == extension) return std::string(type);
  return "application/octet-stream";
}

struct Copy {
  std::string_view coding;
  fs::path file;
};

// In order of preference, and how the names of the files end.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kCodings = {
    {{"br", ".br"}, {"gzip", ".gz"}, {"identity", ""}}};

bool is_compressed_copy(const fs::path& file) { return file.extension() == ".br" || file.extension() == ".gz"; }

// `path` without links and `..`, if it is a file below `root`.
std::optional<fs::path> find_file(const fs::path& root, const fs::path& path) {
  std::error_code error;
  fs::path file = fs::canonical(path, error);
  if (error || !fs::is_regular_file(file, error)) return std::nullopt;
  const auto [inside, rest] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  if (inside != root.end()) return std::nullopt;
  return file;
}

// The compressed copies that there are of a file, and the file itself.
std::vector<Copy> copies_of(const fs::path& root, const fs::path& file) {
  std::vector<Copy> copies;
  for (const auto& [coding, ending] : kCodings)
    if (auto copy = find_file(root, fs::path(file) += ending)) copies.push_back({coding, std::move(*copy)});
  return copies;
}

// The copy that the client prefers; none if it accepts none.
const Copy* choose_copy(const Request& request, const std::vector<Copy>& copies) {
  std::vector<std::string_view> codings;
  for (const Copy& copy : copies) codings.push_back(copy.coding);
  const auto coding = choose_coding(request, codings);
  const auto found = std::ranges::find_if(copies, [&](const Copy& copy) { return copy.coding == coding; });
  return found == copies.end() ? nullptr : &*found;
}

}  // namespace

std::optional<Reply> static_file(const std::string& folder, const Request& request) {
  if (folder.empty()) return std::nullopt;
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) return std::nullopt;
  fs::path path = root / fs::path(request.path).relative_path();
  if (fs::is_directory(path, error)) path /= "index.html";
  const auto file = find_file(root, path);
  if (!file || is_compressed_copy(*file)) return std::nullopt;
  Reply reply;
  const std::vector<Copy> copies = copies_of(root, *file);
  if (const Copy* copy = choose_copy(request, copies)) {
    auto text = read_file(copy->file);
    if (!text) return refusal(500, "io", "the file of this page cannot be read");  // its path is no client's business
    const std::string tag = '"' + sqlite::hex(sqlite::sha256(*text)) + '"';
    reply.type = type_of(*file);
    if (copy->coding != "identity") reply.headers.emplace_back("Content-Encoding", copy->coding);
    reply.headers.emplace_back("ETag", tag);
    reply.headers.emplace_back(
        "Cache-Control", request.path.starts_with("/assets/") ? "public, max-age=31536000, immutable" : "no-cache");
    if (if_none_match_lists(request, tag))
      reply.status = 304;
    else
      reply.text = std::move(*text);
  } else {
    reply = refusal(406, "not_acceptable", "Accept-Encoding allows no coding that there is of this file");
  }
  reply.headers.emplace_back("Vary", "Accept-Encoding");
  return reply;
}

}  // namespace race::server
