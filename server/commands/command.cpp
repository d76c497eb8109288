#include "server/commands/command.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <utility>

#include "core/value/json.h"
#include "server/commands/near_word.h"
#include "server/wire/version.h"

namespace race::server {

int refuse(std::span<const FileErrors> errors, bool json) {
  if (json) std::printf("%s\n", to_json(file_errors_json(errors), 1).c_str());
  print_errors(errors);
  return kExitBadInput;
}

int refuse(const FileErrors& errors, bool json) { return refuse(std::span(&errors, 1), json); }

int refuse(const std::vector<Error>& errors, bool json) { return refuse(FileErrors{"", errors}, json); }

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

// What no function has named as an error: nothing more can be done. No memory is needed to say so.
int give_up(const char* code, const char* why) {
  std::fprintf(stderr, "race: %s: %s\n", code, why);
  return kExitBadInput;
}

int run(const Command& command, std::vector<std::string> words) {
  Arguments arguments{std::string(command.name)};
  const auto run = command.declare(arguments);
  const bool json = std::ranges::find(words, "--json") != words.end();
  const auto outcome = arguments.parse(std::move(words));
  if (outcome == Arguments::Outcome::parsed) return run();
  const std::string usage = "usage: " + arguments.usage() + '\n' + arguments.help();
  if (outcome) {
    print(stdout, std::string(command.name) + ": " + std::string(command.text) + '\n' + usage);
    return kExitOk;
  }
  const Error& error = outcome.error();
  refuse(error, json);
  if (error.code == ErrorCode::missing || error.code == ErrorCode::syntax) print(stderr, usage);
  return kExitBadInput;
}

// Of a word that is no command.
int refuse_command(Commands commands, const std::string& word) {
  std::vector<std::string> names = {"--help", "--version"};
  for (const Command* command : commands) names.emplace_back(command->name);
  refuse(Error{ErrorCode::not_found, "there is no such command" + suggestion(word, names), word});
  print(stderr, "`race --help` lists the commands\n");
  return kExitBadInput;
}

}  // namespace

int run_command(Commands commands, std::vector<std::string> words) try {
  if (!words.empty() && words[0] == "--version") {
    if (words.size() > 1) return refuse(Error{ErrorCode::syntax, "is a word too many", words[1]});
    print(stdout, "race " + std::string(version()) + "\ncompiler: " + std::string(compiler()) + '\n');
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
  if (!words.empty() && !asks_for_help(words[0])) return refuse_command(commands, words[0]);
  print(help ? stdout : stderr, overview(commands));
  return help ? kExitOk : kExitBadInput;
} catch (const std::bad_alloc&) {
  return give_up("out_of_memory", "there is not enough memory");
} catch (const std::exception& failure) {  // such as a thread that cannot be had
  return give_up("internal", failure.what());
}

}  // namespace race::server
