#include "server/commands/file_errors.h"

#include <gtest/gtest.h>

#include <array>

#include "core/value/json.h"

namespace race::server {
namespace {

const Error kError{ErrorCode::type, "must be a string", "Root/A", {3, 5, 3, 6}};

TEST(ErrorLine, HasTheFileFirst) {
  EXPECT_EQ(error_line("a.json", kError), "a.json: Root/A: type: must be a string");
  EXPECT_EQ(error_line("", kError), "Root/A: type: must be a string");
  EXPECT_EQ(error_line("-", {ErrorCode::io, "cannot be read"}), "-: io: cannot be read");
}

TEST(FileErrorsJson, NamesTheFileOfEachError) {
  const std::array all = {FileErrors{"a.json", {kError}}, FileErrors{"", {{ErrorCode::io, "no", "x"}}}};
  EXPECT_EQ(
      to_json(file_errors_json(all)),
      R"({"errors":[{"file":"a.json","path":"Root/A","code":"type","message":"must be a string","line":3,"column":5},)"
      R"({"path":"x","code":"io","message":"no"}]})");
}

}  // namespace
}  // namespace race::server
