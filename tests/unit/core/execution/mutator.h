// Random changes of JSON, for fuzz tests.
#pragma once

#include <random>
#include <span>

#include "core/value/value.h"

namespace race::execution {

class Mutator {
 public:
  /// `words`: strings and keys that changes bring in.
  Mutator(std::uint64_t seed, std::span<const char* const> words) : random_(seed), words_(words) {}

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  // Changes one place at some depth of `value`.
  void mutate(Value& value) {
    const bool list = value.is_list() && !value.as_list().empty(), dict = value.is_dict() && !value.as_dict().empty();
    if ((!list && !dict) || below(8) == 0) {
      value = junk();
    } else if (list) {
      mutate_list(value.mutable_list());
    } else {
      mutate_dict(value.mutable_dict());
    }
  }

  Value junk() {
    switch (below(7)) {
      case 0:
        return Value();
      case 1:
        return static_cast<std::int64_t>(below(9)) - 2;
      case 2:
        return 0.25;
      case 3:
        return Value::unknown();
      case 4:
        return List{Value("A"), Value(Dict{{"kind", "abort"}})};
      case 5:
        return Dict{{"kind", "event"}, {"service", "t"}, {"event", "e0"}, {"data", 1}};
      default:
        return words_[below(words_.size())];
    }
  }

 private:
  void mutate_list(List& items) {
    const std::size_t at = below(items.size());
    if (below(8) == 0) return void(items.erase(items.begin() + static_cast<std::ptrdiff_t>(at)));
    if (below(8) == 0) return items.push_back(Value(items[at]));
    mutate(items[at]);
  }

  void mutate_dict(Dict& fields) {
    const auto entry = *(fields.begin() + static_cast<std::ptrdiff_t>(below(fields.size())));
    if (below(10) == 0) return void(fields.erase(entry.first.as_string()));
    if (below(10) == 0) return fields.set(words_[below(words_.size())], junk());
    Value changed = entry.second;
    mutate(changed);
    fields.set(entry.first, std::move(changed));
  }

  std::mt19937_64 random_;
  std::span<const char* const> words_;
};

}  // namespace race::execution
