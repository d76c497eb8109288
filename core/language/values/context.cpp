#include "core/language/values/context.h"

#include <utility>

#include "core/language/primitives/utf8.h"

namespace race::language {

// A message may quote a value.
Value Context::fail(FaultKind kind, std::string message) {
  constexpr std::size_t kMost = 500;  // bytes
  if (failed) return Value::unknown();
  if (message.size() > kMost) message = std::string(utf8::prefix(message, kMost)) + "...";
  fault = {kind, std::move(message), {}};
  failed = true;
  return Value::unknown();
}

bool Context::fail_over_budget() {
  fail(FaultKind::budget, "more than " + std::to_string(steps) + " steps");
  return false;
}

}  // namespace race::language
