// Expected<T>: a value or an Error. An Error says what was expected, what was found, and where. It reports what a task
// author, a client or a device can cause; our own mistakes are asserts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace race {

/// What a program branches on. The first block holds the codes of a rejected document (core/SEMANTICS.md), the second
/// those of requests and files. `name(code)` gives the text that users see.
enum class ErrorCode {
  // documents and code
  json,
  version,
  missing,
  type,
  unknown_field,
  name,
  duplicate,
  constant,
  parameter,
  root_from,
  first,
  port_target,
  barrier_target,
  link_unknown,
  link_cycle,
  link_field,
  link_parameter,
  link_port,
  oracle,
  after,
  reference,
  keep,
  syntax,
  forbidden,
  scope,
  effect,
  service_call,
  unknown_name,
  // requests and files
  too_large,
  too_deep,
  out_of_range,
  not_found,
  conflict,
  io,
  unavailable,
  not_accepted,
  storage,  // cannot be stored now (the disk is full or fails); nothing is changed
  corrupt,  // what is stored is damaged
  rights,   // who asks may not do that
  stopped,  // the cell is stopped: nothing there moves until it is reset
  leased,   // another run has the service until it is over
};

/// The code as documents, messages and command lines show it, such as "port_target".
std::string_view name(ErrorCode code);
/// The code of this name, if there is one.
std::optional<ErrorCode> code_of(std::string_view name);

/// A range of a code text: lines and columns count from 1, `end_column` is one past the last character. Line 0: none.
struct SourceRange {
  int line = 0;
  int column = 0;
  int end_line = 0;
  int end_column = 0;
  bool operator==(const SourceRange&) const = default;
};

/// One violation: where (the path of a node, `Root/A`, a port, `Root/A.success`, or a field), which rule, and why.
struct Error {
  ErrorCode code;
  std::string message;
  std::string path = {};
  SourceRange where = {};
  std::string id = {};  // `meta.id` of the element that has the code text with `where`, if it has one
  std::string text =
      {};  // the field of that text: entry, exit, when, do, after, from, oracle; empty: it is about no text
  bool operator==(const Error&) const = default;
};

/// `path: code: message`, as commands print it.
std::string to_string(const Error& error);

/// A name as messages show it: `name`, in backquotes.
std::string quote(std::string_view name);

/// `errors` gets `more`, with `below` and a slash before their paths; either may be empty.
void append_below(std::vector<Error>& errors, std::vector<Error> more, const std::string& below);

template <typename T>
using Expected = tl::expected<T, Error>;

/// For checks that list every violation of their input; as many as error_list.h says.
template <typename T>
using Checked = tl::expected<T, std::vector<Error>>;

inline tl::unexpected<Error> unexpected(ErrorCode code, std::string message, std::string path = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(path)});
}

}  // namespace race

#define RACE_CONCAT_INNER(a, b) a##b
#define RACE_CONCAT(a, b) RACE_CONCAT_INNER(a, b)

/// ASSIGN_OR_RETURN(auto x, f()): x is f()'s value, or the caller returns f()'s error.
#define ASSIGN_OR_RETURN(declaration, expression) \
  ASSIGN_OR_RETURN_INNER(RACE_CONCAT(race_expected_, __LINE__), declaration, expression)
#define ASSIGN_OR_RETURN_INNER(temporary, declaration, expression)     \
  auto temporary = (expression);                                       \
  if (!temporary) return tl::unexpected(std::move(temporary).error()); \
  declaration = std::move(*temporary)
