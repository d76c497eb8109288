// The call of an external oracle (thesis 3.3.2), such as `svc.Oracle.decide(par, res, var)`, split into its parts: its
// arguments belong to the scope of the composite, the call itself to the dispatcher.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace race::rcm {

struct CallText {
  struct Argument {
    std::string keyword;  // empty: by position
    std::string expression;
    bool operator==(const Argument&) const = default;
  };
  std::string service, operation;
  std::vector<Argument> arguments;
  bool operator==(const CallText&) const = default;
};

/// The parts of `text`; nothing if it is not one call `svc.SERVICE.OPERATION(arguments)`. Of the expressions, only
/// brackets and strings are parsed.
std::optional<CallText> parse_call(std::string_view text);

}  // namespace race::rcm
