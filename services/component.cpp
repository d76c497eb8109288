#include "services/component.h"

namespace race::services {

Value error_value(std::string_view code, std::string_view message) {
  return Dict{{"code", Value(code)}, {"message", Value(message)}};
}

}  // namespace race::services
