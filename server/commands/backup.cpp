// race backup --data DIR [TO]: copies all that a server keeps, also while it runs: into TO, or to its other backups.
// race restore --data DIR FROM: brings a backup back; no server may run. A damaged file that it replaces is kept as
// NAME.damaged-TIME.
#include "server/store/backup.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "server/commands/command.h"
#include "server/store/data_folder.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

struct Options {
  std::string data = "data";
  std::vector<std::string> folders;  // one at most
};

int back_up(const Options& options) {
  if (options.folders.size() > 1) return refuse({ErrorCode::too_large, "one folder at most", options.folders[1]});
  if (!options.folders.empty()) {
    if (auto done = copy_files(options.data, options.folders[0]); !done) return refuse(done.error());
    std::printf("%s\n", options.folders[0].c_str());
    return kExitOk;
  }
  const auto backup = Backups(options.data).create(now_ms());
  if (!backup) return refuse(backup.error());
  std::printf("%s\n", (std::filesystem::path(options.data) / "backups" / backup->name).c_str());
  return kExitOk;
}

int restore(const Options& options, const std::string& from) {
  const auto folder = DataFolder::take(options.data);
  if (!folder) return refuse(folder.error());
  const auto begin = [&] { return set_damaged_aside(folder->path(), from, now_ms()); };
  if (auto done = restore_files(from, folder->path(), begin); !done) return refuse(done.error());
  return kExitOk;
}

constexpr const char* kData = "what a server keeps (race serve --data)";

std::function<int()> declare_backup(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.text("--data", "DIR", options->data, kData);
  arguments.positionals("TO", options->folders, false);
  return [options] { return back_up(*options); };
}

std::function<int()> declare_restore(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  const auto from = std::make_shared<std::string>();
  arguments.text("--data", "DIR", options->data, kData);
  arguments.positional("FROM", *from, "the folder of a backup");
  return [options, from] { return restore(*options, *from); };
}

}  // namespace

const Command kBackup = {"backup", "copies all that a server keeps, also while it runs", declare_backup};
const Command kRestore = {"restore", "brings a backup back; no server may run on the folder", declare_restore};

}  // namespace race::server
