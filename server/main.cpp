// The program `race`: one table of commands.
#include <array>
#include <string>
#include <vector>

#include "server/commands/command.h"

int main(int argc, char** argv) {
  const std::array commands = {
#ifndef RACE_CORE_ONLY
      &race::server::kServe,  &race::server::kService, &race::server::kRun,       &race::server::kRuns,
      &race::server::kReplay, &race::server::kBackup,  &race::server::kRestore,   &race::server::kCore,
      &race::server::kBoot,   &race::server::kAccount, &race::server::kLogin,     &race::server::kLogout,
      &race::server::kModels, &race::server::kPull,    &race::server::kPush,      &race::server::kStart,
      &race::server::kStop,   &race::server::kServices, &race::server::kCall,
      &race::server::kTrace,  &race::server::kLog,
#endif
      &race::server::kDerive, &race::server::kCheck,   &race::server::kTranslate, &race::server::kFmt,
  };
  return race::server::run_command(commands, {argv + 1, argv + argc});
}
