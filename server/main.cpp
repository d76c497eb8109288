// The program `race`: one table of commands.
#include <cstdio>
#include <string>
#include <vector>

#include "server/commands/command.h"

namespace {

using race::server::Command;

constexpr Command kCommands[] = {
#ifndef RACE_CORE_ONLY
    {"serve", "--port N --data DIR [--headless] [--remote NAME,...]", "serves cores, services and the browser clients",
     race::server::serve_command},
    {"service", "NAME --server URL [--folder DIR] [--database FILE]", "runs services of a server as a process",
     race::server::service_command},
    {"run", "MODEL [--fast] [--seed N] [--arguments JSON] [--json]",
     "runs a task with its own services, without clients", race::server::run_command},
#endif
    {"derive", "MODEL SCRIPT", "prints the derivations of a scripted run", race::server::derive_command},
    {"check", "MODEL [RSM...] [--json]", "lists what is wrong with a document", race::server::check_command},
    {"translate", "MODEL", "prints the native model, without links and oracles", race::server::translate_command},
    {"fmt", "[--write] MODEL...", "prints documents as files should hold them", race::server::fmt_command},
};

int help() {
  std::fprintf(stderr, "usage: race COMMAND ...\n");
  for (const Command& command : kCommands)
    std::fprintf(stderr, "  %-10s %-58s %s\n", command.name.data(), command.usage.data(), command.text.data());
  return race::server::kBadInput;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.empty()) return help();
  for (const Command& command : kCommands)
    if (command.name == arguments[0]) return command.run({arguments.begin() + 1, arguments.end()});
  return help();
}
