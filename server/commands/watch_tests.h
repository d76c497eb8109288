// Runs tests again when what they are made of changes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "server/model_tests/junit.h"

namespace race::server {

/// Runs some test files: what became of all their tests; nothing: something in the files is wrong, and no test counts.
using RunTestFiles = std::function<std::optional<std::vector<TestOutcome>>(const std::vector<std::string>&)>;
/// Is told after each run what became last of the tests of all files; gives the exit code.
using ConcludeTests = std::function<int(const std::vector<TestOutcome>&)>;

/// Calls `run` with the test files of `paths` (as prepare_tests()), and each time that files have changed, with those
/// test files that they concern: the test file, its model, the RSMs that it names, and the cell, which is what else of
/// *.json and *.urdf is in the folder of the model. Where something was wrong, all files of that run are run again with
/// what changes next. SIGINT (Ctrl-C) and SIGTERM end the program: with kExitBadInput while something is wrong, else
/// with what `conclude` has given last.
[[noreturn]] void watch_tests(const std::vector<std::string>& paths, const RunTestFiles& run,
                              const ConcludeTests& conclude);

}  // namespace race::server
