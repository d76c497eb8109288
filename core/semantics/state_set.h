// StateSet: a set of states, walked in tree order while it changes. A bitmap with summaries: adding is O(1), finding
// the next one is a few words, however large the model is.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "core/semantics/program.h"

namespace race::semantics {

class StateSet {
 public:
  explicit StateSet(std::size_t states = 0) {
    do {
      states = (states + 63) / 64;
      levels_.emplace_back(states, 0);
    } while (states > 1);
  }

  void add(StateId s) {
    std::uint32_t i = index(s);
    for (std::vector<std::uint64_t>& level : levels_) {
      std::uint64_t& word = level[i >> 6];
      const std::uint64_t before = word;
      word |= std::uint64_t{1} << (i & 63);
      if (before != 0) return;  // the summaries know of this word
      i >>= 6;
    }
  }

  void remove(StateId s) {
    std::uint32_t i = index(s);
    for (std::vector<std::uint64_t>& level : levels_) {
      std::uint64_t& word = level[i >> 6];
      word &= ~(std::uint64_t{1} << (i & 63));
      if (word != 0) return;
      i >>= 6;
    }
  }

  bool empty() const { return levels_.back()[0] == 0; }

  /// The first member from number `from` on; kNoState if there is none.
  StateId next(std::uint32_t from) const {
    std::size_t level = 0;
    for (;;) {  // up to a word with a member at or after `from`
      const std::size_t word = from >> 6;
      if (word >= levels_[level].size()) return kNoState;
      const std::uint64_t rest = levels_[level][word] >> (from & 63);
      if (rest != 0) {
        from += static_cast<std::uint32_t>(std::countr_zero(rest));
        break;
      }
      if (++level == levels_.size()) return kNoState;
      from = static_cast<std::uint32_t>(word) + 1;
    }
    for (; level > 0; --level)  // down to the member
      from = (from << 6) + static_cast<std::uint32_t>(std::countr_zero(levels_[level - 1][from]));
    return StateId{from};
  }

 private:
  std::vector<std::vector<std::uint64_t>> levels_;  // the members; then, a bit for each word of the level below
};

}  // namespace race::semantics
