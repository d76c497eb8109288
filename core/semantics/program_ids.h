// The ids of a program's elements (rcm `meta.id`), apart from what a step reads: by number, and found by binary search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace race::semantics {

/// The ids of the elements of one kind, by number.
class IdIndex {
 public:
  void add(std::string id) { ids_.push_back(std::move(id)); }
  /// After the last `add`, before the first `find`.
  void finish() {
    for (std::uint32_t number = 0; number < ids_.size(); ++number)
      if (!ids_[number].empty()) order_.push_back(number);
    std::ranges::stable_sort(order_, {}, [this](std::uint32_t number) { return std::string_view(ids_[number]); });
  }

  /// Empty if the element has none.
  const std::string& operator[](std::uint32_t number) const { return ids_[number]; }
  /// The element with this id, the first if a document repeats it.
  std::optional<std::uint32_t> find(std::string_view id) const {
    const auto at = std::ranges::lower_bound(order_, id, {},
                                             [this](std::uint32_t number) { return std::string_view(ids_[number]); });
    if (at == order_.end() || ids_[*at] != id) return std::nullopt;
    return *at;
  }

 private:
  std::vector<std::string> ids_;
  std::vector<std::uint32_t> order_;  // of those that have one
};

/// By StateId, BarrierId, PortId, ActionId, and ValueIndex: the ids of parameters, results and variables.
struct ProgramIds {
  IdIndex states, barriers, ports, actions, values;
};

}  // namespace race::semantics
