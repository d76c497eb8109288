// Runs one test of a model: headless, as fast as world time can pass, on one thread.
#pragma once

#include "server/commands/file_errors.h"
#include "server/commands/prepare_tests.h"
#include "server/model_tests/junit.h"

namespace race::server {

/// What became of the test, and what it covers. The same test and seed give the same. Errors: the cell cannot be built
/// now.
tl::expected<TestOutcome, FileErrors> run_test(const PreparedTest& prepared, std::uint64_t seed, Coverage& coverage);

}  // namespace race::server
