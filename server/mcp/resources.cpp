#include "server/mcp/resources.h"

#include <algorithm>
#include <array>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/mcp/tool.h"

namespace race::server::mcp {
namespace {

constexpr std::string_view kDocumentUri = "race://documents/";
constexpr const char* kJson = "application/json";
constexpr int kPage = 100;

Outcome read_rules(const Context& context, const Dict&) { return context.api.get(Target{"rules"}); }

// What is there beside documents.
struct Resource {
  std::string_view uri, name, title, description;
  Outcome (*read)(const Context& context, const Dict& arguments);
};

constexpr std::array kResources = {
    Resource{"race://rules", "rules", "Rules of the semantics", "Every derivation names rules of this list.",
             read_rules},
    Resource{"race://skills", "skills", "Skills",
             "What a task can be put together from (the first page of list_skills).", list_skills},
    Resource{"race://cell", "cell", "The cell", "Robots, bodies, who has the controls, where the robots are.",
             read_cell},
};

Value resource_json(std::string uri, std::string_view name, std::string_view title, std::string_view description) {
  return Dict{
      {"uri", std::move(uri)}, {"name", name}, {"title", title}, {"description", description}, {"mimeType", kJson}};
}

Value document_json(const Value& summary) {
  const Value* name = summary.find("name");
  const Value* doc = summary.find("doc");
  const std::string text = name && name->is_string() ? name->as_string() : std::string();
  return resource_json(std::string(kDocumentUri) + text, text, text,
                       doc && doc->is_string() ? doc->as_string() : std::string("A document."));
}

RpcError of_problem(const Problem& problem) {
  const Value* errors = problem.errors.find("errors");
  std::vector<Error> list;
  if (errors && errors->is_list())
    for (const Value& each : errors->as_list()) {
      std::vector<Error> unread;
      Fields fields(each, "", "the error", unread);
      const auto code = code_of(fields.text("code").value_or(""));
      list.push_back({code.value_or(ErrorCode::not_accepted), fields.text("message").value_or(""),
                      fields.text("path").value_or("")});
    }
  if (list.empty()) list.push_back({ErrorCode::not_accepted, "the server refuses"});
  return make_rpc_error(problem.status == 404 ? RpcCode::no_resource : RpcCode::internal, list);
}

tl::unexpected<RpcError> wrong_param(const char* name, const char* message) {
  return tl::unexpected(make_rpc_error(RpcCode::invalid_params, {{ErrorCode::type, message, name}}));
}

Outcome read_uri(const Context& context, const std::string& uri) {
  const auto known = std::ranges::find(kResources, uri, &Resource::uri);
  if (known != kResources.end()) return known->read(context, {});
  if (!uri.starts_with(kDocumentUri) || uri.size() == kDocumentUri.size()) return tl::unexpected(no_such(uri));
  return context.api.get(Target{"documents", uri.substr(kDocumentUri.size())});
}

}  // namespace

tl::expected<Value, RpcError> list_resources(const Context& context, const Value& params) {
  const Value* cursor = params.find("cursor");
  if (cursor && !cursor->is_string()) return wrong_param("cursor", "must be a string");
  const Value limit(kPage);
  const auto page = context.api.get(Target{"documents"}.with("after", cursor).with("limit", &limit));
  if (!page) return tl::unexpected(of_problem(page.error()));
  List resources;
  if (!cursor)
    for (const Resource& each : kResources)
      resources.push_back(resource_json(std::string(each.uri), each.name, each.title, each.description));
  const Value* documents = page->find("documents");
  if (documents && documents->is_list())
    for (const Value& summary : documents->as_list()) resources.push_back(document_json(summary));
  Dict answer{{"resources", std::move(resources)}};
  if (const Value* next = page->find("next")) answer.set("nextCursor", *next);
  return answer;
}

tl::expected<Value, RpcError> list_resource_templates(const Context&, const Value& params) {
  if (params.find("cursor")) return wrong_param("cursor", "is of no list");
  return Dict{{"resourceTemplates", List{Dict{{"uriTemplate", std::string(kDocumentUri) + "{name}"},
                                              {"name", "document"},
                                              {"title", "A document"},
                                              {"description", "With its revision and its errors."},
                                              {"mimeType", kJson}}}}};
}

tl::expected<Value, RpcError> read_resource(const Context& context, const Value& params) {
  const Value* uri = params.find("uri");
  if (!uri || !uri->is_string()) return wrong_param("uri", "must be a string");
  const auto read = read_uri(context, uri->as_string());
  if (!read) return tl::unexpected(of_problem(read.error()));
  std::string text = to_json(*read);
  if (text.size() > kMostText)
    return tl::unexpected(
        make_rpc_error(RpcCode::internal,
                       {{ErrorCode::too_large, "has more than 1 MiB; the tool read_document reads documents by pages",
                         uri->as_string()}}));
  return Dict{{"contents", List{Dict{{"uri", *uri}, {"mimeType", kJson}, {"text", std::move(text)}}}}};
}

}  // namespace race::server::mcp
