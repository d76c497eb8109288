#include "server/commands/file_errors.h"

#include <cstdio>

namespace race::server {

std::string error_line(const std::string& file, const Error& error) {
  std::string line;
  for (const std::string& place : {file, error.path})
    if (!place.empty()) line += place + ": ";
  return line + std::string(name(error.code)) + ": " + error.message;
}

void print_errors(std::span<const FileErrors> all) {
  for (const FileErrors& of_file : all)
    for (const Error& error : of_file.errors) std::fprintf(stderr, "%s\n", error_line(of_file.file, error).c_str());
}

Value file_errors_json(std::span<const FileErrors> all) {
  List list;
  for (const FileErrors& of_file : all) {
    for (const Error& error : of_file.errors) {
      Dict json;
      if (!of_file.file.empty()) json.set("file", of_file.file);
      json.set("path", error.path);
      json.set("code", name(error.code));
      json.set("message", error.message);
      if (error.where.line > 0) {
        json.set("line", error.where.line);
        json.set("column", error.where.column);
      }
      list.emplace_back(std::move(json));
    }
  }
  return Dict{{"errors", std::move(list)}};
}

}  // namespace race::server
