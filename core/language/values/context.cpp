#include "core/language/values/context.h"

#include <utility>

namespace race::language {

Value Context::fail(FaultKind kind, std::string message) {
  if (!failed) fault = {kind, std::move(message), {}};
  failed = true;
  return Value::unknown();
}

}  // namespace race::language
