#include "server/commands/file_errors.h"

#include <algorithm>
#include <cstdio>

#include "core/value/error_list.h"

namespace race::server {
namespace {

std::span<const Error> listed(const FileErrors& of_file) {
  return std::span(of_file.errors).first(std::min(of_file.errors.size(), kMaxErrors));
}

}  // namespace

std::string error_line(const std::string& file, const Error& error) {
  std::string line;
  for (const std::string& place : {file, error.path})
    if (!place.empty()) line += place + ": ";
  return line + std::string(name(error.code)) + ": " + error.message;
}

void print_errors(std::span<const FileErrors> all) {
  for (const FileErrors& of_file : all) {
    for (const Error& error : listed(of_file)) std::fprintf(stderr, "%s\n", error_line(of_file.file, error).c_str());
    if (!is_full(of_file.errors)) continue;
    std::fprintf(stderr, "%s%s\n", of_file.file.empty() ? "" : (of_file.file + ": ").c_str(), kMoreErrors);
  }
}

Value file_errors_json(std::span<const FileErrors> all) {
  List list;
  for (const FileErrors& of_file : all) {
    for (const Error& error : listed(of_file)) {
      Dict json;
      if (!of_file.file.empty()) json.set("file", of_file.file);
      json.set("path", error.path);
      json.set("code", name(error.code));
      json.set("message", error.message);
      if (!error.id.empty()) json.set("id", error.id);
      if (!error.text.empty()) json.set("text", error.text);
      if (error.where.line > 0) {
        json.set("line", error.where.line);
        json.set("column", error.where.column);
      }
      list.emplace_back(std::move(json));
    }
  }
  Dict json{{"errors", std::move(list)}};
  if (std::ranges::any_of(all, [](const FileErrors& of_file) { return is_full(of_file.errors); }))
    json.set("more_errors", true);
  return json;
}

}  // namespace race::server
