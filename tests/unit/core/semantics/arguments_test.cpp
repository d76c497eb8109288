// The arguments of a run: parameters of the root, by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/core/semantics/small_runs.h"

namespace race::semantics {
namespace {

constexpr const char* kTask =
    R"({'state': 'R', 'parameters': [{'name': 'size', 'value': 1}, {'name': 'part'}, {'name': 'last', 'value': 3}]})";

TEST(Arguments, OverrideTheParametersThatTheyName) {
  SmallRun run(kTask, Dict{{"part", "cup"}, {"last", 4}});
  run.step();
  EXPECT_EQ(run.get("parameters", "R", "size"), Value(1));
  EXPECT_EQ(run.get("parameters", "R", "part"), Value("cup"));
  EXPECT_EQ(run.get("parameters", "R", "last"), Value(4));
}

TEST(Arguments, ThatAreWrongAreAllNamedAndTheFirstRefusesTheRun) {
  SmallRun run(kTask, Dict{{"part", "cup"}});
  const auto program = std::make_shared<const Program>((*run).program());
  const Dict wrong{{"colour", "red"}, {"size", std::numeric_limits<double>::infinity()}, {"last", 4}};
  const std::vector<Error> errors = check_arguments(*program, wrong);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].path, "arguments/colour");
  EXPECT_EQ(errors[0].code, ErrorCode::unknown_name);
  EXPECT_EQ(errors[1].path, "arguments/size");
  EXPECT_EQ(errors[1].code, ErrorCode::constant);
  EXPECT_EQ(Run::create(program, wrong).error(), errors[0]);
}

}  // namespace
}  // namespace race::semantics
