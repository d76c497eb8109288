#include "core/rcm/model.h"

namespace race::rcm {

bool State::operator==(const State&) const = default;

const std::string& name_of(const Node& node) {
  return std::visit([](const auto& n) -> const std::string& { return n.name; }, node);
}

}  // namespace race::rcm
