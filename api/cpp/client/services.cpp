#include "api/cpp/client/services.h"

#include <string>
#include <utility>

#include "api/cpp/client/calls.h"

namespace race::client {
namespace {

std::string text_or(const Value& error, std::string_view field, const std::string& other) {
  const Value* const text = error.find(field);
  return text && text->is_string() ? text->as_string() : other;
}

ApiError service_error(std::string_view service, std::string_view operation, const Value& error) {
  const std::string name = std::string(service) + '.' + std::string(operation);
  const Dict first{{"path", name},
                   {"code", text_or(error, "code", "error")},
                   {"message", text_or(error, "message", name + " has failed")}};
  ApiError failed = refusal(200, Dict{{"errors", List{first}}});
  failed.service = service;
  failed.operation = operation;
  failed.error = error;
  return failed;
}

}  // namespace

Answered<Value> call_service(const Client& client, std::string_view service, std::string_view operation, List arguments,
                             Dict named) {
  const Value call = Dict{{"operation", operation}, {"args", std::move(arguments)}, {"kwargs", std::move(named)}};
  ASSIGN_OR_RETURN(const Value answer, client.send(calls::call_service(service, call)));
  if (const Value* const error = answer.find("error")) return tl::unexpected(service_error(service, operation, *error));
  const Value* const result = answer.find("result");
  return result ? *result : Value();
}

}  // namespace race::client
