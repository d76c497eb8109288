// Tests of a model as a file beside it (schemas/task_test.json; format in README.md): what is put in, and what must
// come of it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

/// How a mock answers a call of an operation. The answers of an operation are used in their order, one a call.
struct MockAnswer {
  std::string operation;
  bool is_error = false;
  Value data;
  double after = 0;     // s of world time after the call
  bool never = false;   // the call stays open
  bool repeat = false;  // of all later calls, too
};

/// An event that a mock puts at a world time [s].
struct MockEvent {
  std::string event;
  Value data;
  double at = 0;
};

/// What a mock does; where that says nothing, the seed chooses among what the RSM allows.
struct MockScript {
  std::optional<std::string> rsm;  // a file, from the folder of the test file; else the RSM of the cell's service
  std::vector<MockAnswer> answers;
  std::vector<MockEvent> events;  // by time
  Dict samples;                   // event -> data, while the state of the service puts it
};

struct ExpectedCall {
  std::string service, operation;
  std::optional<List> args;
  Dict kwargs;  // those that must be there
};

struct Expectation {
  std::optional<std::string> outcome, status;
  std::vector<std::string> order;  // ports that fire in this order, others between them
  std::vector<std::string> fired, not_fired;
  std::vector<ExpectedCall> calls;  // in this order, others between them
  std::vector<ExpectedCall> not_called;
  Dict results;
  std::optional<double> within;  // s of world time
  double tolerance = 0;          // of numbers in arguments and results
};

struct ModelTest {
  std::string name, doc;
  std::optional<std::string> state;  // of the library, which is the root then
  Dict arguments;
  bool cell = false;  // services are those of the simulated cell, else mocks
  std::optional<std::uint64_t> seed;
  double limit = 0;                            // s of world time
  std::map<std::string, MockScript> services;  // mocks, by key
  Expectation expect;
};

struct TestFile {
  std::optional<std::string> model;  // from the folder of the test file; else NAME.rcm.json of NAME.test.json
  std::vector<ModelTest> tests;
};

inline constexpr std::size_t kMaxTestFile = std::size_t{4} << 20U;  // bytes
inline constexpr std::size_t kMaxTests = 1000;                      // of a file
inline constexpr double kMaxTestSeconds = 86400;                    // of every time in it

/// Reads a test file; all violations, such as at `tests/2/expect/outcome`: those of Fields, `version`, `duplicate` (the
/// name of a test), `out_of_range`, `conflict` (fields that exclude each other), `too_large` (kMaxTests).
Checked<TestFile> read_test_file(const Value& json);
/// From a text; its own codes, with an empty path: those of parse_json, with kMaxTestFile.
Checked<TestFile> read_test_text(std::string_view text);

}  // namespace race::server
