#include "server/commands/command.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "core/execution/derive.h"
#include "core/value/json.h"
#include "server/wire/version.h"

namespace race::server {

int refuse(const std::vector<Error>& errors, bool json) {
  if (json) std::printf("%s\n", to_json(execution::errors_json(errors), 1).c_str());
  for (const Error& error : errors) std::fprintf(stderr, "%s\n", to_string(error).c_str());
  return kExitBadInput;
}

int refuse(const Error& error, bool json) { return refuse(std::vector<Error>{error}, json); }

namespace {

using Commands = std::span<const Command* const>;

void print(std::FILE* stream, const std::string& text) { std::fputs(text.c_str(), stream); }

bool asks_for_help(std::string_view word) { return word == "help" || word == "--help" || word == "-h"; }

std::string overview(Commands commands) {
  std::string text = "usage: race COMMAND ...; race COMMAND --help tells what its options mean; race --version\n";
  for (const Command* command : commands) {
    Arguments arguments{std::string(command->name)};
    command->declare(arguments);
    text += "\n  " + arguments.usage() + "\n      " + std::string(command->text) + '\n';
  }
  return text;
}

int run(const Command& command, std::vector<std::string> words) {
  Arguments arguments{std::string(command.name)};
  const auto run = command.declare(arguments);
  const bool json = std::ranges::find(words, "--json") != words.end();
  const auto outcome = arguments.parse(std::move(words));
  if (!outcome) return refuse(outcome.error(), json);
  if (*outcome == Arguments::Outcome::parsed) return run();
  const std::string usage = "usage: " + arguments.usage() + '\n' + arguments.help();
  if (*outcome == Arguments::Outcome::misused) {
    print(stderr, usage);
    return kExitBadInput;
  }
  print(stdout, std::string(command.name) + ": " + std::string(command.text) + '\n' + usage);
  return kExitOk;
}

}  // namespace

int run_command(Commands commands, std::vector<std::string> words) {
  if (words.size() == 1 && words[0] == "--version") {
    print(stdout, "race " + std::string(version()) + '\n');
    return kExitOk;
  }
  const bool help = !words.empty() && asks_for_help(words[0]);
  if (help && words.size() > 1) {  // `race help run` is `race run --help`
    words[0] = "--help";
    std::swap(words[0], words[1]);
  }
  const auto named = std::ranges::find_if(
      commands, [&](const Command* command) { return !words.empty() && command->name == words[0]; });
  if (named != commands.end()) return run(**named, {words.begin() + 1, words.end()});
  const bool asked = help && words.size() == 1;
  print(asked ? stdout : stderr, overview(commands));
  return asked ? kExitOk : kExitBadInput;
}

}  // namespace race::server
