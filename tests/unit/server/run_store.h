// A store of runs in a folder of its own, for tests.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "core/rsm/document.h"
#include "server/store/runs.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/server/bench.h"

namespace race::server {

inline rsm::Service timer_service() {
  return rsm::read_service_text(R"({"events": [{"name": "tick"}]})", "timer").value();
}

/// A run of a task that counts what `t.tick` brings.
inline execution::Journal counting(const std::vector<int>& ticks) {
  static const rcm::Document document = rcm::read_document_text(R"({"rcm": 1, "services": {"t": "timer"},
    "root": {"state": "Root", "results": [{"name": "n", "initial": 0}],
             "actions": [{"when": "svc.t.tick", "do": "res.n = res.n + svc.t.tick"}],
             "ports": [{"name": "done", "when": "res.n >= 100"}]}})")
                                            .value();
  execution::Journal journal = execution::journal_of(document, {{"t", timer_service()}});
  journal.entries.emplace_back(execution::StartEntry{});
  for (const int tick : ticks) journal.entries.emplace_back(execution::EventEntry{"t", "tick", tick});
  return journal;
}

class StoredRuns : public testing::Test {
 protected:
  std::string path() const { return folder_ / "race.sqlite"; }
  std::unique_ptr<Runs> open() const { return Runs::open(path()).value(); }
  static Runs::NewRun run_of(const execution::Journal& journal, const std::string& document = "task") {
    return {document, 3, journal.header, {{"t", timer_service()}}};
  }
  static RunRecord import(Runs& runs, const execution::Journal& journal, const std::string& status = "aborted") {
    RunRecord record;
    record.status = status;
    return runs.import(record, run_of(journal), journal.entries).value();
  }

  const TemporaryFolder place_;
  const std::filesystem::path folder_ = place_.path;
};

}  // namespace race::server
