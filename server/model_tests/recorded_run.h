// A recorded run as a test is made of it (test_of_run.h): from the store of a server, or from the file of a run.
#pragma once

#include "server/model_tests/test_of_run.h"
#include "server/runs/run_file.h"
#include "server/store/runs.h"

namespace race::server {

RecordedRun recorded_run(RunFile file);
/// Of the store. Errors: those of Runs, journal_of(), services_of() and timing_of().
Expected<RecordedRun> recorded_run(RunId id, Runs& runs);

}  // namespace race::server
