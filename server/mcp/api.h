// Api: what the tools ask the RACE server (api/openapi.yaml), with the rights of the token, and how it refuses.
//
// Threads: any.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/http/client.h"

namespace race::server::mcp {

/// Why the server has not done what it was asked: its errors, as api/schemas/errors.json has them.
struct Problem {
  int status = 0;  // of HTTP; 0: it has not answered, and may have done it, or was not asked
  Dict errors;     // `errors`, `more_errors`
};

/// Of one error of ours; what the client has made long is cut.
Problem make_problem(const Error& error);
/// As the server says that there is no such thing.
Problem no_such(const std::string& what);
/// The errors, and the status if there is one.
Dict problem_json(const Problem& problem);

/// What was answered, or why nothing was done.
using Outcome = tl::expected<Value, Problem>;

/// The path and query of a request: parts are encoded. The server decodes a path before it looks for its parts, so that
/// one with a `/` would be of another route.
class Target {
 public:
  /// Below /api/v1.
  Target(std::initializer_list<std::string_view> parts);
  /// Adds a parameter of the query, if there is a value: a text or a number.
  Target& with(std::string_view name, const Value* value);
  Target& with(std::string_view name, std::string_view text);
  const std::string& text() const { return text_; }
  /// The part with a `/`, which must not be sent; empty: there is none.
  const std::string& wrong_part() const { return wrong_part_; }

 private:
  std::string text_, wrong_part_;
  bool has_query_ = false;
};

class Api {
 public:
  explicit Api(HttpClient client) : client_(std::move(client)) {}

  Outcome get(const Target& target) const { return ask("GET", target); }
  Outcome post(const Target& target, const std::optional<Value>& body = {}) const { return ask("POST", target, body); }
  /// What the server answers. A target with a wrong part is not sent: no_such().
  Outcome ask(std::string_view method, const Target& target, const std::optional<Value>& body = {},
              const HttpClient::Headers& headers = {}) const;

 private:
  const HttpClient client_;
};

}  // namespace race::server::mcp
