// race core ACTION: the cores of a running server, from the command line (api/openapi.yaml, /api/v1/cores).
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include "core/value/json.h"
#include "server/commands/ask_server.h"
#include "server/commands/command.h"
#include "server/commands/core_line.h"

namespace race::server {
namespace {

struct Options {
  std::string action;
  std::vector<std::string> words;
  std::optional<std::string> arguments;
  bool start = false;
  ServerOptions server;
};

// An action is one request. `words` names what stands behind it; `command`: what follows the core in the path.
struct Action {
  std::string_view name, words, method, command;
  bool takes_arguments = false, takes_start = false;

  bool has_id() const { return words.starts_with("ID"); }
  bool has_document() const { return words.ends_with("DOCUMENT"); }
  std::size_t word_count() const { return std::size_t{has_id()} + std::size_t{has_document()}; }
};

constexpr std::array kActions = {
    Action{"list", "", "GET", ""},
    Action{"create", "DOCUMENT", "POST", "", true, true},
    Action{"load", "ID DOCUMENT", "POST", "/load", true, true},
    Action{"start", "ID", "POST", "/start", true},
    Action{"pause", "ID", "POST", "/pause"},
    Action{"resume", "ID", "POST", "/resume"},
    Action{"stop", "ID", "POST", "/stop"},
    Action{"delete", "ID", "DELETE", ""},
    Action{"show", "ID", "GET", ""},
};

std::string action_names() {
  std::string names;
  for (const Action& action : kActions) {
    names += (names.empty() ? "" : ", ") + std::string(action.name);
    if (!action.words.empty()) names += ' ' + std::string(action.words);
  }
  return names;
}

// What is wrong with the command line, which CLI11 does not know.
Expected<const Action*> find_action(const Options& options) {
  const auto action = std::ranges::find(kActions, options.action, &Action::name);
  if (action == kActions.end())
    return unexpected(ErrorCode::syntax, "must be one of " + action_names() + "; got `" + options.action + "`",
                      "ACTION");
  const std::string name(action->name);
  if (options.words.size() != action->word_count())
    return unexpected(ErrorCode::syntax, "the form is `race core " + name + ' ' + std::string(action->words) + '`',
                      "ACTION");
  if (options.arguments && !action->takes_arguments)
    return unexpected(ErrorCode::unknown_field, '`' + name + "` takes no arguments", "--arguments");
  if (options.start && !action->takes_start)
    return unexpected(ErrorCode::unknown_field, '`' + name + "` starts nothing", "--start");
  return &*action;
}

// One line for each core of an answer.
Expected<std::string> lines_of(const Value& answer) {
  const Value* list = answer.find("cores");
  const List cores = list && list->is_list() ? list->as_list() : List{answer};
  std::string lines;
  for (const Value& core : cores) {
    ASSIGN_OR_RETURN(const std::string line, core_line(core));
    lines += line + '\n';
  }
  return lines;
}

tl::expected<Value, int> ask(const Action& action, const Options& options, std::optional<Dict> arguments) {
  const std::string core_or_all = action.has_id() ? core_path(options.words.front()) : kCores,
                    target = core_or_all + std::string(action.command);
  Dict body;
  if (action.has_document()) body.set("document", options.words.back());
  if (arguments) body.set("arguments", std::move(*arguments));
  auto core = ask_server(options.server, action.method, target,
                         body.empty() ? std::nullopt : std::optional<Value>(std::move(body)));
  if (!core || !options.start) return core;
  const Value* id = core->find("id");
  if (!id || !id->is_string()) return core;  // what is no core is refused when it is printed
  return ask_server(options.server, "POST", core_path(id->as_string()) + "/start");
}

int run(const Options& options) {
  const bool json = options.server.json;
  const auto action = find_action(options);
  if (!action) return refuse(action.error(), json);
  std::optional<Dict> arguments;
  if (options.arguments) {
    auto read = read_object("--arguments", *options.arguments);
    if (!read) return refuse(read.error(), json);
    arguments = std::move(*read);
  }
  const auto answer = ask(**action, options, std::move(arguments));
  if (!answer) return answer.error();
  const auto lines = lines_of(*answer);
  if (!lines) return refuse(Error{lines.error().code, lines.error().message, options.server.url}, json);
  std::fputs(json ? (to_json(*answer, 1) + '\n').c_str() : lines->c_str(), stdout);
  return (*action)->name == "show" && answer->find("fault") ? kExitFindings : kExitOk;
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.positional("ACTION", options->action, action_names());
  std::vector<std::string> names;
  for (const Action& action : kActions) names.emplace_back(action.name);
  arguments.suggest("ACTION", std::move(names));
  arguments.positionals("WORD", options->words, false);
  arguments.text("--arguments", "JSON", options->arguments,
                 "parameters of the task, an object; for create, load, start");
  arguments.flag("--start", options->start, "starts what was created or loaded");
  options->server.declare(arguments, "prints what the server answers, as JSON");
  return [options] { return run(*options); };
}

}  // namespace

const Command kCore = {"core", "creates, starts, shows and removes the cores of a running server", declare};

}  // namespace race::server
