// The commands on documents: translate, fmt, check.
#include <cstdio>
#include <fstream>

#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "core/rsm/document.h"
#include "core/semantics/derive.h"
#include "core/value/json.h"
#include "server/commands/command.h"

namespace race::server {
namespace {

Checked<rcm::Document> load(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(std::vector<Error>{text.error()});
  return rcm::read_document_text(*text);
}

// race translate MODEL: the native model, without links and oracles, and where each of its elements comes from.
int translate(const std::vector<std::string>& arguments) {
  if (arguments.size() != 1) return misused(kTranslate);
  const auto document = load(arguments[0]);
  if (!document) return refuse(document.error());
  const auto native = rcm::translate(*document);
  if (!native) return refuse(native.error());
  Dict origin;
  for (const auto& [path, from] : native->origin) origin.set(path, from);
  Dict out;
  out.set("rcm", 1);
  out.set("name", document->name);
  out.set("root", rcm::write_state(native->root));
  out.set("origin", std::move(origin));
  std::printf("%s\n", to_json(out, 2).c_str());
  return kExitOk;
}

// race fmt [--write] MODEL...: the documents as files should hold them, on stdout or in place.
int format(const std::vector<std::string>& arguments) {
  bool write = false;
  std::vector<std::string> paths;
  for (const std::string& argument : arguments) argument == "--write" ? void(write = true) : paths.push_back(argument);
  if (paths.empty()) return misused(kFmt);
  for (const std::string& path : paths) {
    const auto document = load(path);
    if (!document) return refuse(document.error());
    const std::string text = rcm::format_document(*document);
    if (!write) {
      std::fwrite(text.data(), 1, text.size(), stdout);
      continue;
    }
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out << text;
    if (!out.flush()) return refuse(Error{ErrorCode::io, "cannot be written", path});
  }
  return kExitOk;
}

// race check MODEL [RSM...] [--json]: all violations of a document and of service descriptions.
int check(const std::vector<std::string>& arguments) {
  bool json = false;
  std::vector<std::string> paths;
  for (const std::string& argument : arguments) argument == "--json" ? void(json = true) : paths.push_back(argument);
  if (paths.empty()) return misused(kCheck);
  std::vector<Error> errors;
  if (const auto document = load(paths[0]); !document) errors = document.error();
  for (std::size_t i = 1; i < paths.size(); ++i) {
    const auto text = read_file(paths[i]);
    if (!text) {
      errors.push_back(text.error());
      continue;
    }
    const auto service = rsm::read_service_text(*text, paths[i]);
    if (!service) errors.insert(errors.end(), service.error().begin(), service.error().end());
  }
  if (!errors.empty()) return refuse(errors, json);
  if (json) std::printf("%s\n", to_json(semantics::errors_json({}), 1).c_str());
  return kExitOk;
}

}  // namespace

const Command kTranslate = {"translate", "MODEL", "prints the native model, without links and oracles", translate};
const Command kFmt = {"fmt", "[--write] MODEL...", "prints documents as files should hold them, or writes them so",
                      format};
const Command kCheck = {"check", "MODEL [RSM...] [--json]", "lists what is wrong with a document or a service", check};

}  // namespace race::server
