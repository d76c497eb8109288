// Outcomes of tests as JUnit XML, which CI systems read. Pure.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "server/model_tests/expectations.h"

namespace race::server {

/// What became of a test.
struct TestOutcome {
  std::string file, name;
  std::uint64_t seed = 0;
  double time = 0;                // s of world time
  std::vector<Finding> findings;  // empty: it passed
};

/// A document with one suite for each file; the time of a test is world time, so that the text is a function of what
/// was tested.
std::string junit_xml(std::span<const TestOutcome> outcomes);

}  // namespace race::server
