// race check MODEL [FILE...] [--json]: all that is wrong with documents (RCM) and service descriptions (RSM), by file.
// The first file is a document. A later one is one too if its JSON has a field of documents alone, `rcm` or `root`, and
// else a service description. Exit 1 if something is wrong in a file, 2 if a file cannot be read or is no JSON.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "core/rcm/document.h"
#include "core/rsm/document.h"
#include "core/value/json.h"
#include "server/commands/command.h"
#include "server/commands/input.h"

namespace race::server {
namespace {

/// What became of a file.
struct CheckedFile {
  FileErrors found;
  bool readable = true;  // it holds JSON, whatever that is worth
};

std::vector<Error> violations(const Value& json, bool is_first) {
  if (is_first || json.find("rcm") || json.find("root")) {
    auto document = rcm::read_document(json);
    return document ? std::vector<Error>{} : std::move(document).error();
  }
  auto service = rsm::read_service(json, "");
  return service ? std::vector<Error>{} : std::move(service).error();
}

CheckedFile check_file(const std::string& path, bool is_first) {
  const auto unreadable = [&path](Error error) { return CheckedFile{{path, {std::move(error)}}, false}; };
  const auto text = read_input(path);
  if (!text) return unreadable(text.error());
  const auto json = parse_json(*text, JsonLimits{.keep_out_of_range = true});
  if (!json) return unreadable(json.error());
  return {{path, violations(*json, is_first)}};
}

// {"files": [{"file", "errors": [...]}]}; each with `more_errors` if there are more than are listed.
void print_json(const std::vector<CheckedFile>& files) {
  List list;
  for (const CheckedFile& each : files) {
    const FileErrors nameless{"", each.found.errors};
    Dict entry{{"file", each.found.file}};
    const Value errors = file_errors_json(std::span(&nameless, 1));
    for (const auto& [key, value] : errors.as_dict()) entry.set(key, value);
    list.emplace_back(std::move(entry));
  }
  std::printf("%s\n", to_json(Dict{{"files", std::move(list)}}, 1).c_str());
}

int check(const std::vector<std::string>& paths, bool json) {
  std::vector<CheckedFile> files;
  for (const std::string& path : paths) files.push_back(check_file(path, files.empty()));
  for (const CheckedFile& each : files) print_errors(std::span(&each.found, 1));
  if (json) print_json(files);
  if (!std::ranges::all_of(files, &CheckedFile::readable)) return kExitBadInput;
  const bool fine = std::ranges::all_of(files, [](const CheckedFile& each) { return each.found.errors.empty(); });
  return fine ? kExitOk : kExitFindings;
}

std::function<int()> declare(Arguments& arguments) {
  struct Options {
    std::vector<std::string> files;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  arguments.files("FILE", options->files, "documents and RSMs: the first is a document, a later one if it has `rcm`");
  arguments.flag("--json", options->json, "prints each file and its errors as JSON to stdout, too");
  return [options] { return check(options->files, options->json); };
}

}  // namespace

const Command kCheck = {"check", "lists what is wrong with documents and service descriptions", declare};

}  // namespace race::server
