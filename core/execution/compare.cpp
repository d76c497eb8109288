#include "core/execution/compare.h"

#include <algorithm>

#include "core/execution/step_json.h"

namespace race::execution {
namespace {

// The next macro step as schemas/trace_step.json; null: there is none.
Expected<Value> next_step(JournalWalk& walk) {
  if (walk.at_end()) return Value();
  ASSIGN_OR_RETURN(const Progress* progress, walk.next({.derivation = true}));
  Dict step = trace_step(walk.execution().run().program(), *progress);
  step.set("state", walk.execution().run().state_json());
  return Value(std::move(step));
}

bool same(const Value& first, const Value& second) {
  if (first.is_null() || second.is_null()) return false;
  for (const char* part : {"micro", "calls", "state"})
    if (*first.find(part) != *second.find(part)) return false;
  return true;
}

// The first micro step of which the derivations differ.
std::optional<std::size_t> first_derivation(const Value& first, const Value& second) {
  if (first.is_null() || second.is_null()) return std::nullopt;
  const List& a = first.find("micro")->as_list();
  const List& b = second.find("micro")->as_list();
  const auto [in_a, in_b] = std::ranges::mismatch(a, b);
  if (in_a == a.end() && in_b == b.end()) return std::nullopt;
  return static_cast<std::size_t>(in_a - a.begin());
}

}  // namespace

Expected<Comparison> compare(JournalWalk& first, JournalWalk& second, std::uint64_t most) {
  Comparison comparison{.compared = first.execution().run().position()};
  for (std::uint64_t i = 0; i < most && !(first.at_end() && second.at_end()); ++i) {
    ASSIGN_OR_RETURN(Value a, next_step(first));
    ASSIGN_OR_RETURN(Value b, next_step(second));
    if (!same(a, b)) {
      const auto micro = first_derivation(a, b);
      comparison.difference = {comparison.compared + 1, micro, std::move(a), std::move(b)};
      return comparison;
    }
    ++comparison.compared;
  }
  return comparison;
}

}  // namespace race::execution
