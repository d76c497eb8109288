#include "services/host_function.h"

#include <utility>

#include "services/arguments.h"

namespace race::services {

Expected<Dict> read_operation(const rsm::Service& service, std::string_view function, const Dict& arguments) {
  return bind_arguments(*find_operation(service, function), Call{0, std::string(function), {}, arguments});
}

Expected<Dict> read_no_arguments(std::string_view function, const Dict& arguments) {
  if (arguments.empty()) return arguments;
  return unexpected(ErrorCode::unknown_field, "`" + std::string(function) + "` has no arguments", "arguments");
}

tl::unexpected<Error> unknown_function(const rsm::Service& service, std::string_view function) {
  return unexpected(ErrorCode::not_found, "no `" + service.name + "` asks this", std::string(function));
}

Value refusal_reply(const Error& error) { return Dict{{"not_found", error.message}}; }

Expected<Value> read_reply(Expected<Value> reply) {
  const Value* absent = reply ? reply->find("not_found") : nullptr;
  if (absent && absent->is_string()) return unexpected(ErrorCode::not_found, absent->as_string(), "display");
  return reply;
}

Expected<std::uint64_t> read_id(Expected<Value> reply) {
  ASSIGN_OR_RETURN(const Value id, read_reply(std::move(reply)));
  if (!id.is_integer()) return unexpected(ErrorCode::type, "the server gives no id");
  return static_cast<std::uint64_t>(id.as_integer());
}

}  // namespace race::services
