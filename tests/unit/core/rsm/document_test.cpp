// Services from and to JSON: what is read, and each violation.
#include "core/rsm/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/value/json.h"
#include "tests/unit/core/rsm/robot.h"

namespace race::rsm {
namespace {

using testing::ElementsAre;

std::vector<ErrorCode> codes(std::string_view text) {
  const auto service = read_service_text(text, "services/S");
  std::vector<ErrorCode> out;
  if (service) return out;
  for (const Error& error : service.error()) {
    EXPECT_EQ(error.path, "services/S");
    EXPECT_FALSE(error.message.empty());
    out.push_back(error.code);
  }
  return out;
}

TEST(ReadService, ReadsWhatIsDeclared) {
  const Service robot = read_robot();
  EXPECT_EQ(robot.operations[0].parameters[1].value, Value(1.0));
  EXPECT_TRUE(robot.operations[1].safe);
  EXPECT_TRUE(read_service_text(R"({"operations": [{"name": "f", "moves": true}]})", "").value().operations[0].moves);
  EXPECT_TRUE(read_service_text(R"({"operations": [{"name": "f", "held": true}]})", "").value().operations[0].held);
  EXPECT_TRUE(read_service_text(R"({"operations": [{"name": "f", "paces": true}]})", "").value().operations[0].paces);
  EXPECT_TRUE(read_service_text(R"({"operations": [{"name": "f", "reads": true}]})", "").value().operations[0].reads);
  EXPECT_TRUE(robot.events[0].sampled);
  EXPECT_EQ(robot.events[0].rate_hz, 100.0);
  EXPECT_EQ(robot.transitions[0].defer, std::vector<std::string>{"arrive"});
  EXPECT_EQ(robot.transitions[4].src, std::nullopt);
  EXPECT_EQ(robot.transitions[4].error, "aborted");
  EXPECT_FALSE(robot.is_interface());
}

TEST(ReadService, TakesAnInterfaceWithoutNameAndStates) {
  const auto service = read_service_text(R"({"operations": [{"name": "op"}], "events": []})", "services/S");
  ASSERT_TRUE(service);
  EXPECT_TRUE(service->is_interface());
}

TEST(WriteService, IsReadBackAsItWas) {
  Service robot = read_robot();
  robot.subscribes = {{"camera", "cloud"}};
  robot.calls = {{"camera", "grab"}};
  robot.meta = Dict{{"icon", "arm"}};
  robot.operations[0].doc = "moves";
  robot.operations[0].moves = robot.operations[0].held = robot.operations[0].paces = robot.operations[0].reads = true;
  robot.operations[0].parameters[0] = {"pose", "pose", "m", "where to", -1.5, 2.0, std::nullopt};
  EXPECT_EQ(read_service(write_service(robot), "").value(), robot);
  const std::string text = to_json(write_service(robot));
  EXPECT_EQ(to_json(write_service(read_service_text(text, "").value())), text);
}

TEST(ReadService, ListsViolationsOfTheFormat) {
  EXPECT_THAT(codes("{"), ElementsAre(ErrorCode::json));
  EXPECT_THAT(codes("[]"), ElementsAre(ErrorCode::type));
  EXPECT_THAT(codes(R"({"rsm": 2})"), ElementsAre(ErrorCode::version));
  EXPECT_THAT(codes(R"({"what": 1})"), ElementsAre(ErrorCode::unknown_field));
  EXPECT_THAT(codes(R"({"events": 1})"), ElementsAre(ErrorCode::type));
  EXPECT_THAT(codes(R"({"operations": [{}]})"), ElementsAre(ErrorCode::missing));
  EXPECT_THAT(codes(R"({"operations": [{"name": ""}]})"), ElementsAre(ErrorCode::name));
  EXPECT_THAT(codes(R"({"operations": [{"name": "o", "result": "float"}]})"), ElementsAre(ErrorCode::type));
  EXPECT_THAT(codes(R"({"operations": [{"name": "o", "safe": 1}]})"), ElementsAre(ErrorCode::type));
  EXPECT_THAT(codes(R"({"operations": [{"name": "o", "held": "yes"}]})"), ElementsAre(ErrorCode::type));
  EXPECT_THAT(codes(R"({"operations": [{"name": "o", "paces": 1}]})"), ElementsAre(ErrorCode::type));
  EXPECT_THAT(codes(R"({"operations": [{"name": "o", "reads": 1}]})"), ElementsAre(ErrorCode::type));
  EXPECT_THAT(codes(R"({"operations": [{"name": "o", "parameters": [{"name": "p", "max": 1e999}]}]})"),
              ElementsAre(ErrorCode::constant));
  EXPECT_THAT(codes(R"({"calls": [{"service": "s"}]})"), ElementsAre(ErrorCode::missing));
}

TEST(ReadService, ListsNamesThatAreNoneOrDeclaredTwice) {
  EXPECT_THAT(codes(R"({"name": "a b"})"), ElementsAre(ErrorCode::name));
  EXPECT_THAT(codes(R"({"events": [{"name": "1"}]})"), ElementsAre(ErrorCode::name));
  EXPECT_THAT(codes(R"({"events": [{"name": "e"}, {"name": "e"}]})"), ElementsAre(ErrorCode::duplicate));
  EXPECT_THAT(codes(R"({"events": [{"name": "e"}], "operations": [{"name": "e"}]})"),
              ElementsAre(ErrorCode::duplicate));
  EXPECT_THAT(codes(R"({"operations": [{"name": "o", "parameters": [{"name": "p"}, {"name": "p"}]}]})"),
              ElementsAre(ErrorCode::duplicate));
  EXPECT_THAT(codes(R"({"states": [{"name": "X"}, {"name": "X"}], "init": "X"})"), ElementsAre(ErrorCode::duplicate));
  EXPECT_THAT(codes(R"({"states": [{"name": "X"}], "init": "X",
                        "transitions": [{"id": "t", "dst": "X"}, {"id": "t", "dst": "X"}]})"),
              ElementsAre(ErrorCode::duplicate));
}

TEST(ReadService, ListsReferencesToNothing) {
  const auto with = [](const std::string& transition) {
    return codes(R"({"states": [{"name": "X"}], "init": "X", "transitions": [)" + transition + "]}");
  };
  EXPECT_THAT(with(R"({"id": "t", "dst": "Y"})"), ElementsAre(ErrorCode::reference));
  EXPECT_THAT(with(R"({"id": "t", "dst": "X", "src": "Y"})"), ElementsAre(ErrorCode::reference));
  EXPECT_THAT(with(R"({"id": "t", "dst": "X", "operation": "o"})"), ElementsAre(ErrorCode::reference));
  EXPECT_THAT(with(R"({"id": "t", "dst": "X", "events": ["e"]})"), ElementsAre(ErrorCode::reference));
  EXPECT_THAT(with(R"({"id": "t", "dst": "X", "defer": ["u"]})"), ElementsAre(ErrorCode::reference));
  EXPECT_THAT(codes(R"({"states": [{"name": "X", "events": ["e"]}], "init": "X"})"), ElementsAre(ErrorCode::reference));
  EXPECT_THAT(codes(R"({"states": [{"name": "X"}], "init": "Y"})"), ElementsAre(ErrorCode::reference));
}

TEST(ReadService, WithStatesNeedsInit) {
  EXPECT_THAT(codes(R"({"states": [{"name": "X"}]})"), ElementsAre(ErrorCode::missing));
}

}  // namespace
}  // namespace race::rsm
