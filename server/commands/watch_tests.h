// Runs tests again when what they are made of changes.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace race::server {

/// Runs some test files and gives the exit code.
using RunTestFiles = std::function<int(const std::vector<std::string>&)>;

/// Calls `run` with the test files of `paths` (as prepare_tests()), and each time that files have changed, with those
/// test files that they concern: the test file, its model, the RSMs that it names, and the cell, which is what else of
/// *.json and *.urdf is in the folder of the model. SIGINT (Ctrl-C) and SIGTERM end the program, with the largest of
/// the last exit codes of each test file.
[[noreturn]] void watch_tests(const std::vector<std::string>& paths, const RunTestFiles& run);

}  // namespace race::server
