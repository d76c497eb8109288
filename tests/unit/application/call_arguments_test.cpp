#include "server/commands/call_arguments.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/value/json.h"

namespace race::server {
namespace {

// The call as JSON, or the code of the error.
std::string call(const std::vector<std::string>& words) {
  Dict call;
  const auto read = read_call_arguments(words, call);
  return read ? to_json(call) : std::string(name(read.error().code));
}

TEST(ReadCallArguments, AreByNameJsonOrElseATextEach) {
  EXPECT_EQ(call({}), "{}");
  EXPECT_EQ(call({"width=0.05", "part=cube", "pose=[1,2]", "label=\"7\"", "on=true", "empty=", "a=b=c"}),
            R"({"kwargs":{"width":0.05,"part":"cube","pose":[1,2],"label":"7","on":true,"empty":"","a":"b=c"}})");
}

TEST(ReadCallArguments, AreOneObjectOrList) {
  EXPECT_EQ(call({R"({"width": 0.05})"}), R"({"kwargs":{"width":0.05}})");
  EXPECT_EQ(call({"[1, {}]"}), R"({"args":[1,{}]})");
}

TEST(ReadCallArguments, RefuseWhatIsNone) {
  EXPECT_EQ(call({"{"}), "json");
  EXPECT_EQ(call({"width"}), "syntax");
  EXPECT_EQ(call({"=1"}), "syntax");
  EXPECT_EQ(call({"a b=1"}), "syntax");
  EXPECT_EQ(call({"{}", "a=1"}), "syntax");
  EXPECT_EQ(call({"a=1", "a=2"}), "duplicate");
}

TEST(ReadOperation, HasAServiceAndItsOperation) {
  const auto read = read_operation("robot.state");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->service + " " + read->operation, "robot state");
  for (const char* none : {"robot", ".state", "robot.", "", "."})
    EXPECT_EQ(read_operation(none).error().code, ErrorCode::syntax) << none;
}

}  // namespace
}  // namespace race::server
