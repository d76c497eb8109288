#include "server/commands/table.h"

#include <array>

namespace race::server {

std::span<const Command* const> all_commands() {
  static constexpr std::array commands = {
#ifndef RACE_CORE_ONLY
      &kServe,  &kService, &kRun,       &kTest,   &kRuns,   &kReplay, &kBackup, &kRestore,    &kCore,
      &kBoot,   &kAccount, &kLogin,     &kLogout, &kModels, &kPull,   &kPush,   &kBundle,     &kInstall,
      &kStart,  &kStop,    &kServices,  &kCall,   &kTrace,  &kLog,    &kMcp,    &kCompletion,
#endif
      &kDerive, &kCheck,   &kTranslate, &kFmt,    &kMan,
  };
  return commands;
}

}  // namespace race::server
