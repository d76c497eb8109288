// race runs --data DIR [--json]: lists the runs that are stored in a data folder, the newest first, also while a server
// runs. Damaged ones are named; then the exit code is 1.
#include "server/store/runs.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

#include "core/value/json.h"
#include "server/commands/command.h"
#include "server/runs/run_json.h"
#include "server/wire/errors.h"

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
  std::vector<Error> damaged;
  for (std::optional<RunId> before = 0; before;) {
    const auto block = (*runs)->list(*before, kBlock);
    if (!block) return refuse(block.error(), json);
    std::ranges::copy(block->errors(), std::back_inserter(damaged));
    for (const RunRecord& run : block->runs) {
      if (json)
        all.push_back(run_json(run));
      else
        print(run);
    }
    before = block->next;
  }
  Dict list{{"runs", std::move(all)}};
  if (!damaged.empty()) list.set("damaged", error_list(damaged));
  if (json) std::printf("%s\n", to_json(std::move(list), 1).c_str());
  if (damaged.empty()) return kExitOk;
  refuse(damaged);
  return kExitFindings;
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
