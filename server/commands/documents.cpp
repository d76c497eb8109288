// The commands on documents: translate, fmt, check.
#include <cstdio>
#include <memory>

#include "core/execution/derive.h"
#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/rcm/translate.h"
#include "core/rsm/document.h"
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
int translate(const std::string& path) {
  const auto document = load(path);
  if (!document) return refuse(document.error());
  const auto native = rcm::translate(*document);
  if (!native) return refuse(native.error());
  Dict origin;
  for (const auto& [element, from] : native->origin) origin.set(element, from);
  Dict out;
  out.set("rcm", 1);
  out.set("name", document->name);
  out.set("root", rcm::write_state(native->root));
  out.set("origin", std::move(origin));
  std::printf("%s\n", to_json(out, 2).c_str());
  return kExitOk;
}

// race fmt MODEL... [--write]: the documents as files should hold them, every element with an id, on stdout or in
// place.
int format(const std::vector<std::string>& paths, bool write) {
  for (const std::string& path : paths) {
    const auto old = read_file(path);
    if (!old) return refuse(old.error());
    auto document = rcm::read_document_text(*old);
    if (!document) return refuse(document.error());
    rcm::give_ids(*document);
    const auto text = rcm::write_document_text(*document);
    if (!text) return refuse(Error{text.error().code, text.error().message, path});
    if (!write) {
      std::fwrite(text->data(), 1, text->size(), stdout);
      continue;
    }
    if (*text == *old) continue;
    if (auto replaced = replace_file(path, *text); !replaced) return refuse(replaced.error());
  }
  return kExitOk;
}

// race check MODEL [RSM...] [--json]: all violations of a document and of service descriptions.
int check(const std::string& model, const std::vector<std::string>& services, bool json) {
  std::vector<Error> errors;
  if (const auto document = load(model); !document) errors = document.error();
  for (const std::string& path : services) {
    const auto text = read_file(path);
    if (!text) {
      errors.push_back(text.error());
      continue;
    }
    const auto service = rsm::read_service_text(*text, path);
    if (!service) errors.insert(errors.end(), service.error().begin(), service.error().end());
  }
  if (!errors.empty()) return refuse(errors, json);
  if (json) std::printf("%s\n", to_json(execution::errors_json({}), 1).c_str());
  return kExitOk;
}

std::function<int()> declare_translate(Arguments& arguments) {
  const auto path = std::make_shared<std::string>();
  arguments.positional("MODEL", *path);
  return [path] { return translate(*path); };
}

std::function<int()> declare_format(Arguments& arguments) {
  struct Options {
    std::vector<std::string> paths;
    bool write = false;
  };
  const auto options = std::make_shared<Options>();
  arguments.positionals("MODEL", options->paths, true);
  arguments.flag("--write", options->write, "writes the files instead of stdout");
  return [options] { return format(options->paths, options->write); };
}

std::function<int()> declare_check(Arguments& arguments) {
  struct Options {
    std::string model;
    std::vector<std::string> services;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  arguments.positional("MODEL", options->model);
  arguments.positionals("RSM", options->services, false);
  arguments.flag("--json", options->json, "prints the errors as JSON to stdout, too");
  return [options] { return check(options->model, options->services, options->json); };
}

}  // namespace

const Command kTranslate = {"translate", "prints the native model, without links and oracles", declare_translate};
const Command kFmt = {"fmt", "prints documents as files should hold them, with ids, or writes them so", declare_format};
const Command kCheck = {"check", "lists what is wrong with a document or a service", declare_check};

}  // namespace race::server
