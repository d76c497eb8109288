// race boot ACTION: what a server starts when it begins, from the command line (api/openapi.yaml, /api/v1/boot).
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/commands/ask_server.h"
#include "server/commands/command.h"

namespace race::server {
namespace {

constexpr const char* kRoute = "/api/v1/boot";

struct Options {
  std::string action;
  std::vector<std::string> words;
  std::string arguments = "{}";
  ServerOptions server;
};

// What is wrong with the command line, which CLI11 does not know.
Expected<void> check(const Options& options) {
  const bool list = options.action == "list", set = options.action == "set", remove = options.action == "remove";
  if (!list && !set && !remove)
    return unexpected(ErrorCode::syntax, "must be one of list, set, remove; got `" + options.action + "`", "ACTION");
  if (options.words.size() != (list ? 0 : 1))
    return unexpected(ErrorCode::syntax, "the form is `race boot " + options.action + (list ? "`" : " DOCUMENT`"),
                      "ACTION");
  return {};
}

struct Entry {
  std::string document;
  Value arguments;
};

// Error `io`: this is no boot list.
Expected<std::vector<Entry>> read_entries(const Value& answer) {
  std::vector<Error> errors;
  std::vector<Entry> entries;
  Fields fields(answer, "", "the boot list", errors);
  for (const Value& each : fields.list("entries", Fields::Need::required)) {
    Fields of_one(each, "", "the entry", errors);
    const auto document = of_one.text("document", Fields::Need::required);
    const Value* arguments = of_one.find("arguments", Fields::Need::required);
    if (document && arguments) entries.push_back({*document, *arguments});
  }
  if (!errors.empty()) return unexpected(ErrorCode::io, "answers what is no boot list");
  return entries;
}

Value to_body(const std::vector<Entry>& entries) {
  List list;
  for (const Entry& entry : entries) list.push_back(Dict{{"document", entry.document}, {"arguments", entry.arguments}});
  return Dict{{"entries", std::move(list)}};
}

// `set` changes the entry of the document, or adds one at the end. Error `not_found`: there is none to remove.
Expected<void> change(std::vector<Entry>& entries, const Options& options, Dict arguments) {
  const std::string& document = options.words.front();
  const auto found = std::ranges::find(entries, document, &Entry::document);
  const bool is_new = found == entries.end();
  if (options.action == "remove") {
    if (is_new) return unexpected(ErrorCode::not_found, "the boot list has no such document", document);
    entries.erase(found);
  } else if (is_new) {
    entries.push_back({document, std::move(arguments)});
  } else {
    found->arguments = std::move(arguments);
  }
  return {};
}

int print(const std::vector<Entry>& entries, bool json) {
  if (json) std::printf("%s\n", to_json(to_body(entries), 1).c_str());
  for (const Entry& entry : entries)
    if (!json) std::printf("%-20s  %s\n", entry.document.c_str(), to_json(entry.arguments).c_str());
  return kExitOk;
}

int run(const Options& options) {
  const bool json = options.server.json;
  if (const auto fine = check(options); !fine) return refuse(fine.error(), json);
  auto arguments = read_object("--arguments", options.arguments);
  if (!arguments) return refuse(arguments.error(), json);
  auto answer = ask_server(options.server, "GET", kRoute);
  if (!answer) return answer.error();
  auto entries = read_entries(*answer);
  if (!entries) return refuse(Error{entries.error().code, entries.error().message, options.server.url}, json);
  if (options.action == "list") return print(*entries, json);
  if (const auto changed = change(*entries, options, std::move(*arguments)); !changed) {
    refuse(changed.error(), json);
    return kExitFindings;
  }
  answer = ask_server(options.server, "PUT", kRoute, to_body(*entries));
  return answer ? print(*entries, json) : answer.error();
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.positional("ACTION", options->action, "list, set DOCUMENT, remove DOCUMENT");
  arguments.suggest("ACTION", {"list", "set", "remove"});
  arguments.positionals("WORD", options->words, false);
  arguments.text("--arguments", "JSON", options->arguments, "of set: parameters of the task, an object");
  options->server.declare(arguments, "prints the list as JSON");
  return [options] { return run(*options); };
}

}  // namespace

const Command kBoot = {"boot", "shows and changes what a server starts when it begins", declare};

}  // namespace race::server
