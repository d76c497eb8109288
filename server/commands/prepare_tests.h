// Reads test files with all that they name, and refuses them as a whole if anything in them is wrong.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rcm/model.h"
#include "server/commands/file_errors.h"
#include "server/model_tests/coverage.h"
#include "server/model_tests/test_file.h"
#include "server/model_tests/tested_model.h"

namespace race::server {

inline constexpr std::string_view kTestEnding = ".test.json", kModelEnding = ".rcm.json";

/// Files NAME.test.json of a folder (not of its folders), by name; of what is no folder: itself.
std::vector<std::string> test_files(const std::string& path);

/// The file of the model; nothing: the test file names none, and is not called NAME.test.json.
std::optional<std::string> model_file_of(const std::string& test_file, const TestFile& content);

/// A test that can run.
struct PreparedTest {
  std::string file, path;          // where it is: "pick.test.json", "tests/2"
  std::string model_file, folder;  // of the model; its folder is that of the cell
  ModelTest test;
  rcm::Document document;  // with the root that the test wants
  Interfaces mocks;        // the RSM of each
  Coverage::Origin origin;
  std::shared_ptr<const semantics::Program> program;
};

struct PreparedTests {
  std::vector<PreparedTest> tests;           // in order of the files
  std::map<std::string, Coverage> coverage;  // by file of the model: of its root and of each state of its library
};

/// Of test files, or folders, which stand for those in them (test_files()). Errors: of each
/// file all that is wrong in it, in its model and in the RSMs that it names, by file; `not_found`: a folder without
/// tests.
tl::expected<PreparedTests, std::vector<FileErrors>> prepare_tests(const std::vector<std::string>& paths);

}  // namespace race::server
