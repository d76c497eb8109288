#include "server/application/boot.h"

#include <algorithm>

#include "server/execution/cores.h"
#include "server/log/event_log.h"
#include "server/store/boot_list.h"
#include "server/store/documents.h"
#include "server/store/runs.h"

namespace race::server {
namespace {

// The id of the core that was started.
Checked<std::string> start(const BootEntry& entry, Documents& documents, Cores& cores) {
  const auto stored = documents.get(entry.document);
  if (!stored) return tl::unexpected(stored.error());
  const auto core = cores.create(*stored, entry.arguments);
  if (!core) return tl::unexpected(core.error());
  if (auto started = (*core)->start(); !started) return tl::unexpected(std::vector<Error>{std::move(started).error()});
  return (*core)->id();
}

// How a run that is not over stands; one that could not be rebuilt has no core.
std::string status_of(const RunRecord& run, const Cores& cores) {
  const auto core = cores.find(std::to_string(run.id));
  return core ? (*core)->info().find("status")->as_string() : "not rebuilt";
}

}  // namespace

void boot(const BootResources& resources) {
  const auto say = [&](const std::string& text, LogLevel level = LogLevel::warning) {
    resources.log.append(resources.clock.now(), "server", "boot: " + text, level);
  };
  const auto entries = resources.list.get();
  if (!entries) return say("nothing is started: " + to_string(entries.error()));
  const auto open_runs = resources.runs.open_runs();
  if (!open_runs) return say("nothing is started: " + to_string(open_runs.error()));
  const auto damaged = std::ranges::find(open_runs->damaged, false, &DamagedRun::is_over);
  if (damaged != open_runs->damaged.end())  // it may be of any document
    return say("nothing is started: " + to_string(damaged->error));
  for (const BootEntry& entry : *entries) {
    const auto open = std::ranges::find(open_runs->runs, entry.document, &RunRecord::document);
    if (open != open_runs->runs.end()) {
      say(entry.document + " is not started: its run " + std::to_string(open->id) + " is " +
          status_of(*open, resources.cores));
      continue;
    }
    if (const auto started = start(entry, resources.documents, resources.cores))
      say(entry.document + " is started as core " + *started, LogLevel::info);
    else
      for (const Error& error : started.error()) say(entry.document + " is not started: " + to_string(error));
  }
}

}  // namespace race::server
