// What a test expects, held against what its run has done. Pure.
#pragma once

#include <string>
#include <vector>

#include "server/model_tests/observed.h"
#include "server/model_tests/test_file.h"

namespace race::server {

/// Why a test fails: the place of the expectation in its file, and what was seen.
struct Finding {
  std::string path, message;
  bool operator==(const Finding&) const = default;
};

/// Whether `seen` has what is expected: numbers within `tolerance`, whether they are int or double; of an object, the
/// fields that `expected` has; of a list, all items.
bool matches(const Value& expected, const Value& seen, double tolerance);

/// All that is not as expected; empty: the test passes. `path`: that of the test, such as `tests/2`.
std::vector<Finding> unmet_expectations(const Expectation& expect, const Observed& seen, const std::string& path);

}  // namespace race::server
