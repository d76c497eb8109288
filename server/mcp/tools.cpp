#include "server/mcp/tools.h"

#include <algorithm>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/mcp/schema.h"
#include "server/wire/errors.h"

namespace race::server::mcp {
namespace {

Value tool_json(const Tool& tool) {
  return Dict{{"name", tool.name},
              {"title", tool.title},
              {"description", tool.description},
              {"inputSchema", schema_of(tool)},
              {"annotations", Dict{{"title", tool.title},
                                   {"readOnlyHint", tool.hints.reads},
                                   {"destructiveHint", tool.hints.destroys},
                                   {"idempotentHint", tool.hints.idempotent},
                                   {"openWorldHint", false}}}};
}

// Whether the server says that who asks may change documents. Otherwise it would refuse.
bool may_change_documents(const Context& context) {
  const auto me = context.api.get(Target{"me"});
  const Value* role = me ? me->find("role") : nullptr;
  return role && (*role == Value("developer") || *role == Value("admin"));
}

tl::unexpected<RpcError> bad_params(const std::vector<Error>& errors) {
  return tl::unexpected(make_rpc_error(RpcCode::invalid_params, errors));
}

// nullptr: there is none of this name.
const Tool* find_tool(std::string_view name) {
  const auto tool = std::ranges::find(all_tools(), name, &Tool::name);
  return tool == all_tools().end() ? nullptr : &*tool;
}

Value text_result(Value structured, std::string text, bool is_error) {
  return Dict{{"content", List{Dict{{"type", "text"}, {"text", std::move(text)}}}},
              {"structuredContent", std::move(structured)},
              {"isError", is_error}};
}

}  // namespace

Value schema_of(const Tool& tool) {
  const std::string text = R"({"type": "object", "properties": {)" + std::string(tool.properties) +
                           R"(}, "required": [)" + std::string(tool.required) + R"(], "additionalProperties": false})";
  return parse_json(text).value();
}

tl::expected<Value, RpcError> list_tools(const Context& context, const Value& params) {
  if (params.find("cursor")) return bad_params({{ErrorCode::not_found, "is of no list", "cursor"}});
  const bool may_change = may_change_documents(context);
  List tools;
  for (const Tool& tool : all_tools())
    if (may_change || tool.kind != ToolKind::changes_documents) tools.push_back(tool_json(tool));
  return Dict{{"tools", std::move(tools)}};
}

tl::expected<Value, RpcError> call_tool(const Context& context, const Value& params) {
  std::vector<Error> errors;
  Fields fields(params, "", "the call", errors, kByField);
  const auto name = fields.text("name", kRequired);
  const Value* given = fields.find("arguments");
  if (!errors.empty()) return bad_params(errors);
  const Tool* tool = find_tool(*name);
  if (!tool) return bad_params({{ErrorCode::not_found, "there is no tool " + quote(*name), "name"}});
  const Value arguments = given ? *given : Value(Dict());
  if (!arguments.is_dict()) return bad_params({{ErrorCode::type, "must be an object", "arguments"}});
  const auto wrong = violations(schema_of(*tool), arguments, "arguments");
  if (!wrong.empty()) return tool_result(tl::unexpected(Problem{0, errors_json(wrong).as_dict()}));
  return tool_result(tool->call(context, arguments.as_dict()));
}

bool calls_stop(const Value& params) {
  const Value* name = params.find("name");
  const Tool* tool = name && name->is_string() ? find_tool(name->as_string()) : nullptr;
  return tool && tool->kind == ToolKind::stops;
}

Value tool_result(const Outcome& outcome) {
  Value structured = outcome ? *outcome : Value(problem_json(outcome.error()));
  std::string text = to_json(structured);
  if (text.size() <= kMostText) return text_result(std::move(structured), std::move(text), !outcome);
  const std::string message =
      "the answer would have " + std::to_string(text.size()) + " bytes, and has at most 1 MiB: ask for less, by pages";
  structured = problem_json(make_problem({ErrorCode::too_large, message}));
  text = to_json(structured);
  return text_result(std::move(structured), std::move(text), true);
}

}  // namespace race::server::mcp
