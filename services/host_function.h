// What a process asks the desk of its component (services/remote/desk.h), as a table of functions, and how the answers
// look on both ends. Of `display` and `audio`: their screens stay in the server.
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

/// A function that a process may ask of `HostFunctions`.
template <typename HostFunctions>
struct HostFunction {
  std::string_view name;
  Expected<Value> (*answer)(HostFunctions& desk, const Dict& arguments);
  bool operation = true;  // of the RSM, with its parameters; else without any
};

/// The arguments of a question, held to what the operation of this name lets through; those that are absent have their
/// declared values. Errors: those of bind_arguments().
Expected<Dict> read_operation(const rsm::Service& service, std::string_view function, const Dict& arguments);
/// Of a function without any. Error `unknown_field`: there are some.
Expected<Dict> read_no_arguments(std::string_view function, const Dict& arguments);
/// Error `not_found`, with the function as its path.
tl::unexpected<Error> unknown_function(const rsm::Service& service, std::string_view function);

/// Asks `desk` one of `functions` of its `service`. Errors are those of a question that no component asks.
template <typename HostFunctions, std::size_t kSize>
Expected<Value> call_host_function(const rsm::Service& service,
                                   const std::array<HostFunction<HostFunctions>, kSize>& functions, HostFunctions& desk,
                                   std::string_view function, const Dict& arguments) {
  const auto known = std::ranges::find(functions, function, &HostFunction<HostFunctions>::name);
  if (known == functions.end()) return unknown_function(service, function);
  ASSIGN_OR_RETURN(const Dict bound, known->operation ? read_operation(service, function, arguments)
                                                      : read_no_arguments(function, arguments));
  return known->answer(desk, bound);
}

/// What a desk refuses for a reason that a task can meet, a good answer: {"not_found": why}.
Value refusal_reply(const Error& error);
/// The answer, or what it refuses: an error `not_found` of `display`.
Expected<Value> read_reply(Expected<Value> answer);
/// An id in an answer.
Expected<std::uint64_t> read_id(Expected<Value> answer);

}  // namespace race::services
