// Makes a test file of a run that is stored, or in a file.
#pragma once

#include <optional>
#include <string>

#include "server/commands/file_errors.h"

namespace race::server {

/// Writes the file `path`, which must not be there yet, with one test: that its model comes to what it came to in the
/// run (model_tests/test_of_run.h). `run`: a file (GET /api/v1/runs/ID/export), or, with `data`, the folder of a
/// server, the number of a run. Errors, nothing is written then: `conflict`: there is such a file; `name`: it is not
/// called NAME.test.json; those of Runs and read_run_file_text(), of test_of_run(), and of a test file (`too_large`).
tl::expected<void, FileErrors> write_test_of_run(const std::string& path, const std::string& run,
                                                 const std::optional<std::string>& data);

}  // namespace race::server
