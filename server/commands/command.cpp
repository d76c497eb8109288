#include "server/commands/command.h"

#include <algorithm>
#include <cstdio>

#include "core/semantics/derive.h"
#include "core/value/json.h"

namespace race::server {

int refuse(const std::vector<Error>& errors, bool json) {
  if (json) std::printf("%s\n", to_json(semantics::errors_json(errors), 1).c_str());
  for (const Error& error : errors) std::fprintf(stderr, "%s\n", to_string(error).c_str());
  return kExitBadInput;
}

int refuse(const Error& error, bool json) { return refuse(std::vector<Error>{error}, json); }

std::string usage(const Command& command) {
  return "usage: race " + std::string(command.name) + ' ' + std::string(command.arguments) + '\n' +
         (command.options ? command.options() : "");
}

int misused(const Command& command) {
  std::fputs(usage(command).c_str(), stderr);
  return kExitBadInput;
}

namespace {

bool asks_for_help(std::string_view word) { return word == "--help" || word == "-h"; }

std::string overview(std::span<const Command* const> commands) {
  std::string text = "usage: race COMMAND ...; race COMMAND --help tells what its options mean\n";
  for (const Command* command : commands) {
    text += "\n  race " + std::string(command->name) + ' ' + std::string(command->arguments) + '\n';
    text += "      " + std::string(command->text) + '\n';
  }
  return text;
}

}  // namespace

int run_command(std::span<const Command* const> commands, const std::vector<std::string>& words) {
  const auto named = [&](std::string_view name) -> const Command* {
    const auto found = std::ranges::find(commands, name, [](const Command* command) { return command->name; });
    return found == commands.end() ? nullptr : *found;
  };
  const bool help = !words.empty() && (words[0] == "help" || asks_for_help(words[0]));
  const std::size_t at = help ? 1 : 0;  // where the command stands
  const Command* command = at < words.size() ? named(words[at]) : nullptr;
  if (command && (help || std::ranges::any_of(words, asks_for_help))) {
    std::printf("%s: %s\n", std::string(command->name).c_str(), std::string(command->text).c_str());
    std::fputs(usage(*command).c_str(), stdout);
    return kExitOk;
  }
  if (command) return command->run({words.begin() + 1, words.end()});
  const bool asked = help && words.size() == 1;
  std::fputs(overview(commands).c_str(), asked ? stdout : stderr);
  return asked ? kExitOk : kExitBadInput;
}

}  // namespace race::server
