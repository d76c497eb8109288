// HostFunction: a function of the server that a component calls from a process of its own (services/remote,
// host_functions.h), as a row of a table; and the form of the replies, for both ends. For `display` and `audio`, whose
// screens stay in the server.
//
// Threads: any.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/rsm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::services {

/// One function of `Backend`, which a process may call.
template <typename Backend>
struct HostFunction {
  std::string_view name;
  Expected<Value> (*answer)(Backend& backend, const Dict& arguments);
  bool operation = true;  // of the RSM, with its parameters; else without any
};

/// The arguments of a call, checked as those of the operation of this name; absent ones have their declared values.
/// Errors: those of bind_arguments().
Expected<Dict> read_operation(const rsm::Service& service, std::string_view function, const Dict& arguments);
/// Those of a function without any. Error `unknown_field`: there are some.
Expected<Dict> read_no_arguments(std::string_view function, const Dict& arguments);
/// Error `not_found`, with the function as its path.
tl::unexpected<Error> unknown_function(const rsm::Service& service, std::string_view function);

/// Calls one of `functions` of the `service`. The errors are those of a call that no component makes.
template <typename Backend, std::size_t kSize>
Expected<Value> call_host_function(const rsm::Service& service,
                                   const std::array<HostFunction<Backend>, kSize>& functions, Backend& backend,
                                   std::string_view function, const Dict& arguments) {
  const auto known = std::ranges::find(functions, function, &HostFunction<Backend>::name);
  if (known == functions.end()) return unknown_function(service, function);
  ASSIGN_OR_RETURN(const Dict bound, known->operation ? read_operation(service, function, arguments)
                                                      : read_no_arguments(function, arguments));
  return known->answer(backend, bound);
}

/// The reply of a function that refuses for a reason that a task can meet: {"not_found": why}.
Value refusal_reply(const Error& error);
/// The reply, or, if it refuses, an error `not_found` of `display`.
Expected<Value> read_reply(Expected<Value> reply);
/// The id that a reply is.
Expected<std::uint64_t> read_id(Expected<Value> reply);

}  // namespace race::services
