#include "server/commands/file_errors.h"

#include <gtest/gtest.h>

#include <array>

#include "core/value/error_list.h"
#include "core/value/json.h"
#include "server/wire/errors.h"

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

TEST(FileErrorsJson, NamesTheCodeTextOfAnError) {
  const FileErrors all{"", {{ErrorCode::syntax, "expected an expression", "Root/A", {1, 2, 1, 3}, "w3n8k2pa", "when"}}};
  EXPECT_EQ(to_json(file_errors_json(std::span(&all, 1))),
            R"({"errors":[{"path":"Root/A","code":"syntax","message":"expected an expression","id":"w3n8k2pa",)"
            R"("text":"when","line":1,"column":2}]})");
  EXPECT_EQ(errors_json(all.errors), file_errors_json(std::span(&all, 1)));
}

TEST(FileErrorsJson, SaysThatThereAreMoreThanItLists) {
  FileErrors all{"a.json", std::vector(kMaxErrors, kError)};
  EXPECT_EQ(file_errors_json(std::span(&all, 1)).find("more_errors"), nullptr);
  all.errors.push_back(kError);
  const Value json = file_errors_json(std::span(&all, 1));
  EXPECT_EQ(json.find("errors")->as_list().size(), kMaxErrors);
  EXPECT_EQ(*json.find("more_errors"), Value(true));
}

TEST(ErrorsJson, SaysThatThereAreMoreThanItLists) {
  std::vector<Error> errors(kMaxErrors, kError);
  EXPECT_EQ(errors_json(errors).find("more_errors"), nullptr);
  errors.push_back(kError);
  EXPECT_EQ(errors_json(errors).find("errors")->as_list().size(), kMaxErrors);
  EXPECT_EQ(*errors_json(errors).find("more_errors"), Value(true));
}

}  // namespace
}  // namespace race::server
