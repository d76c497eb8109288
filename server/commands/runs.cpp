// race runs --data DIR [--json]: lists the runs that are stored in a data folder, the newest first, also while a server
// runs.
#include "server/store/runs.h"

#include <cstdio>
#include <memory>

#include "core/value/json.h"
#include "server/commands/command.h"
#include "server/runs/run_json.h"

namespace race::server {
namespace {

constexpr std::size_t kBlock = 100;

void print(const RunRecord& run) {
  const std::string result = run.status == "ended" ? run.status + " (" + run.outcome + ")" : run.status;
  std::printf("%llu  %s  revision %lld  %s  %llu steps%s\n", static_cast<unsigned long long>(run.id),
              run.document.c_str(), static_cast<long long>(run.revision), result.c_str(),
              static_cast<unsigned long long>(run.steps), run.imported ? "  imported" : "");
}

int list(const std::string& data, bool json) {
  const auto runs = Runs::open_to_read(data + "/race.sqlite");
  if (!runs) return refuse(runs.error(), json);
  List all;
  for (RunId before = 0;;) {
    const auto block = (*runs)->list(before, kBlock);
    if (!block) return refuse(block.error(), json);
    for (const RunRecord& run : *block) {
      if (json)
        all.push_back(run_json(run));
      else
        print(run);
    }
    if (block->size() < kBlock) break;
    before = block->back().id;
  }
  if (json) std::printf("%s\n", to_json(Dict{{"runs", std::move(all)}}, 1).c_str());
  return kExitOk;
}

std::function<int()> declare(Arguments& arguments) {
  struct Options {
    std::string data;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  arguments.required_text("--data", "DIR", options->data, "the folder of a server");
  arguments.flag("--json", options->json, "as JSON (api/schemas/runs.json)");
  return [options] { return list(options->data, options->json); };
}

}  // namespace

const Command kRuns = {"runs", "lists the runs that a data folder keeps", declare};

}  // namespace race::server
