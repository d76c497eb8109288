// A test of a recorded run: its inputs become what mocks answer, and what came of them is what is expected. Pure.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "core/execution/journal.h"
#include "server/model_tests/tested_model.h"

namespace race::server {

struct RecordedRun {
  execution::Journal journal;
  std::vector<double> times;  // s, of each entry; none: they are not known
  Interfaces services;        // the RSMs of the moment
};

/// The text of a test file (schemas/task_test.json) with one test of this name. Inputs come at the times of the run, in
/// whole milliseconds and apart, so that their order is the same. What no code reads of an operation's responses is
/// drawn. Errors: `not_accepted`: the run is not over, or somebody has edited, forced or aborted it; `unavailable`:
/// somebody has set `stop` (which may be null) meanwhile; those of the journal, and of a test file with their paths
/// (`too_large`; `out_of_range`: it took longer than a test may).
Checked<std::string> test_of_run(const std::string& name, const RecordedRun& run,
                                 const std::atomic<bool>* stop = nullptr);

}  // namespace race::server
