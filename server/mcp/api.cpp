#include "server/mcp/api.h"

#include "core/value/error_list.h"
#include "core/value/json.h"
#include "server/http/encode_part.h"
#include "server/wire/errors.h"

namespace race::server::mcp {

Problem make_problem(const Error& error) {
  std::vector<Error> errors;
  add_error(errors, error);
  return {0, errors_json(errors).as_dict()};
}

Problem no_such(const std::string& what) {
  return {404, make_problem({ErrorCode::not_found, "there is nothing of this name", what}).errors};
}

Dict problem_json(const Problem& problem) {
  Dict json = problem.errors;
  if (problem.status != 0) json.set("status", problem.status);
  return json;
}

Target::Target(std::initializer_list<std::string_view> parts) : text_("/api/v1") {
  for (const std::string_view part : parts) {
    text_ += '/' + encode_part(part);
    if (part.find('/') != std::string_view::npos) wrong_part_ = part;
  }
}

Target& Target::with(std::string_view name, const Value* value) {
  if (!value) return *this;
  return with(name, std::string_view(value->is_string() ? value->as_string() : to_json(*value)));
}

Target& Target::with(std::string_view name, std::string_view text) {
  text_ += (has_query_ ? '&' : '?') + std::string(name) + '=' + encode_part(text);
  has_query_ = true;
  return *this;
}

Outcome Api::ask(std::string_view method, const Target& target, const std::optional<Value>& body,
                 const HttpClient::Headers& headers) const {
  if (!target.wrong_part().empty()) return tl::unexpected(no_such(target.wrong_part()));
  auto answer = client_.request(method, target.text(), body, headers);
  if (!answer) return tl::unexpected(make_problem(answer.error()));
  if (answer->status >= 200 && answer->status < 300) return std::move(answer->body);
  Problem problem{answer->status, {}};
  for (const char* key : {"errors", "more_errors"})
    if (const Value* found = answer->body.find(key)) problem.errors.set(key, *found);
  if (problem.errors.empty())
    problem.errors = make_problem({ErrorCode::io, "the server answers " + std::to_string(answer->status)}).errors;
  return tl::unexpected(std::move(problem));
}

}  // namespace race::server::mcp
