#include "core/rcm/model.h"

namespace race::rcm {

namespace {

// Clang 16 crashes on the defaulted comparison below if it has to generate that of a state's children in its midst.
[[maybe_unused]] bool are_equal(const std::vector<Node>& a, const std::vector<Node>& b) { return a == b; }

}  // namespace

bool State::operator==(const State&) const = default;

const std::string& name_of(const Node& node) {
  return std::visit([](const auto& n) -> const std::string& { return n.name; }, node);
}

}  // namespace race::rcm
