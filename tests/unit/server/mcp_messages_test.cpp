// What of a message is read, which requests are worked on, and what arguments a schema takes.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/value/json.h"
#include "server/mcp/batch.h"
#include "server/mcp/calls.h"
#include "server/mcp/schema.h"
#include "server/mcp/tools.h"

namespace race::server::mcp {
namespace {

using namespace std::chrono_literals;

tl::expected<std::optional<Message>, Refusal> message_in(const std::string& text) {
  return read_message(parse_json(text).value());
}

TEST(JsonRpc, ReadsRequestsNotificationsAndResponses) {
  const auto request =
      message_in(R"({"jsonrpc": "2.0", "id": "a", "method": "m", "params": {"x": 1}})").value().value();
  EXPECT_EQ(*request.id, Value("a"));
  EXPECT_EQ(request.method, "m");
  EXPECT_EQ(*request.params.find("x"), Value(1));
  const auto notification = message_in(R"({"jsonrpc": "2.0", "method": "m"})").value().value();
  EXPECT_FALSE(notification.id);
  EXPECT_TRUE(notification.params.is_dict());
  EXPECT_FALSE(message_in(R"({"jsonrpc": "2.0", "id": 1, "result": {}})").value());
  EXPECT_FALSE(message_in(R"({"jsonrpc": "2.0", "id": 1, "error": {}})").value());
}

TEST(JsonRpc, RefusesWithTheIdThatItKnows) {
  const auto nameless = message_in(R"({"jsonrpc": "2.0", "id": 7})");
  EXPECT_EQ(nameless.error().id, Value(7));
  EXPECT_EQ(nameless.error().error.errors.front().path, "method");
  EXPECT_TRUE(message_in(R"({"jsonrpc": "2.0", "id": true, "method": "m"})").error().id.is_null());
  EXPECT_TRUE(message_in("3").error().id.is_null());
  const auto params = message_in(R"({"jsonrpc": "2.0", "id": 7, "method": "m", "params": 3})");
  EXPECT_EQ(params.error().error.code, RpcCode::invalid_params);
}

TEST(Calls, AreSoManyAndEachIdIsOneOfThem) {
  Calls calls;
  for (int id = 0; id < static_cast<int>(Calls::kMost); ++id) EXPECT_TRUE(calls.begin(id));
  EXPECT_EQ(calls.begin("more").error().code, RpcCode::busy);
  EXPECT_EQ(calls.begin(3).error().code, RpcCode::invalid_request);
  calls.close(3);
  EXPECT_EQ(calls.begin("more").error().code, RpcCode::busy) << "its response is not written yet";
  for (std::size_t i = 0; i < Calls::kMostStops; ++i)
    EXPECT_TRUE(calls.begin("stop " + std::to_string(i), Calls::kMost + Calls::kMostStops));
  EXPECT_EQ(calls.begin("stop", Calls::kMost + Calls::kMostStops).error().code, RpcCode::busy);
  for (std::size_t i = 0; i < Calls::kMostStops; ++i) calls.end();
  calls.end();
  EXPECT_TRUE(calls.begin("3")) << "another id than 3";
}

TEST(Calls, AreCancelledAloneOrTogether) {
  Calls calls;
  const auto one = calls.begin(1).value(), other = calls.begin(2).value();
  calls.cancel(9);
  calls.cancel(1);
  EXPECT_TRUE(*one);
  EXPECT_FALSE(*other);
  EXPECT_FALSE(calls.wait_until_none(1ms));
  calls.cancel_all();
  EXPECT_TRUE(*other);
  for (const int id : {1, 2}) calls.close(id), calls.end();
  EXPECT_TRUE(calls.wait_until_none(0ms));
}

TEST(Batch, SendsAllResponsesOnceTheLastIsThere) {
  List sent;
  Batch batch(3, [&sent](const Value& message) { sent.push_back(message); });
  batch.add(Value(1));
  batch.add(std::nullopt);
  EXPECT_TRUE(sent.empty());
  batch.add(Value(2));
  EXPECT_EQ(sent, (List{Value(List{1, 2})}));
  Batch silent(1, [&sent](const Value& message) { sent.push_back(message); });
  silent.add(std::nullopt);
  EXPECT_EQ(sent.size(), 1U);
}

TEST(Schema, NamesEachViolationByItsPath) {
  const Value schema = parse_json(R"({"type": "object", "additionalProperties": false, "required": ["name", "n"],
      "properties": {"name": {"type": "string", "minLength": 1}, "n": {"type": "integer", "minimum": 1, "maximum": 3},
                     "x": {"type": "number"}, "kind": {"type": "string", "enum": ["a", "b"]}, "any": {}}})")
                           .value();
  const auto found = [&](const std::string& text) {
    std::string all;
    for (const Error& error : violations(schema, parse_json(text).value(), "a"))
      all += error.path + ' ' + std::string(name(error.code)) + ';';
    return all;
  };
  EXPECT_EQ(found(R"({"name": "x", "n": 3, "x": 1, "kind": "a", "any": null})"), "");
  EXPECT_EQ(found(R"({"name": "x", "n": 1, "x": 1.5})"), "");
  EXPECT_EQ(found("{}"), "a/name missing;a/n missing;");
  EXPECT_EQ(found("[]"), "a type;");
  EXPECT_EQ(found(R"({"name": "", "n": 0, "x": "1", "kind": "c", "more": 1})"),
            "a/name out_of_range;a/n out_of_range;a/x type;a/kind out_of_range;a/more unknown_field;");
  EXPECT_EQ(found(R"({"name": null, "n": 1.0})"), "a/name type;a/n type;");
  EXPECT_EQ(found(R"({"name": "x", "n": 4})"), "a/n out_of_range;");
}

TEST(ToolTable, HasASchemaAndANameOfItsOwnForEachTool) {
  std::set<std::string_view> names;
  for (const Tool& tool : all_tools()) {
    EXPECT_TRUE(names.insert(tool.name).second) << tool.name;
    const Value schema = schema_of(tool);
    for (const Value& required : schema.find("required")->as_list())
      EXPECT_TRUE(schema.find("properties")->find(required.as_string())) << tool.name;
    EXPECT_FALSE(tool.hints.reads && tool.hints.destroys) << tool.name;
  }
}

TEST(ToolTable, KnowsTheCallsThatStop) {
  EXPECT_TRUE(calls_stop(Dict{{"name", "stop_cell"}}));
  EXPECT_TRUE(calls_stop(Dict{{"name", "stop_run"}, {"arguments", 7}}));
  for (const Value& params : List{Dict(), Dict{{"name", 7}}, Dict{{"name", "stop"}}, Dict{{"name", "wait_for_run"}}})
    EXPECT_FALSE(calls_stop(params));
}

TEST(ToolResult, SaysWhatIsTooLarge) {
  const auto with = [](std::size_t size) { return tool_result(Value(Dict{{"x", std::string(size, 'x')}})); };
  const std::size_t most = kMostText - std::string(R"({"x":""})").size();
  EXPECT_EQ(*with(most).find("isError"), Value(false));
  const Value larger = with(most + 1);
  EXPECT_EQ(*larger.find("isError"), Value(true));
  EXPECT_EQ(*larger.find("structuredContent")->find("errors")->as_list().front().find("code"), Value("too_large"));
}

}  // namespace
}  // namespace race::server::mcp
