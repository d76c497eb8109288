// StateSet: a set of states, walked in tree order while it changes. A bitmap with summaries: adding is O(1), finding
// the next one is a few words, however large the model is.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/semantics/program.h"

namespace race::semantics {

class StateSet {
 public:
  explicit StateSet(std::size_t states = 0) {
    std::size_t words = 0;
    do {
      states = (states + 63) / 64;
      levels_[depth_++] = static_cast<std::uint32_t>(words);
      words += states;
    } while (states > 1);
    words_.assign(words, 0);
  }

  void add(StateId s) {
    std::uint32_t i = index(s);
    for (std::size_t level = 0; level < depth_; ++level, i >>= 6) {
      std::uint64_t& word = words_[levels_[level] + (i >> 6)];
      const std::uint64_t before = word;
      word |= std::uint64_t{1} << (i & 63);
      if (level == 0) members_ += word != before ? 1 : 0;
      if (before != 0) return;  // the summaries know of this word
    }
  }

  void remove(StateId s) {
    std::uint32_t i = index(s);
    for (std::size_t level = 0; level < depth_; ++level, i >>= 6) {
      std::uint64_t& word = words_[levels_[level] + (i >> 6)];
      const std::uint64_t before = word;
      word &= ~(std::uint64_t{1} << (i & 63));
      if (level == 0) members_ -= word != before ? 1 : 0;
      if (word != 0) return;
    }
  }

  bool empty() const { return members_ == 0; }

  /// The first member from number `from` on; kNoState if there is none.
  StateId next(std::uint32_t from) const {
    if (members_ == 0) return kNoState;
    for (std::size_t level = 0; level < depth_; ++level) {  // up to a word with a member at or after `from`
      const std::uint32_t word = levels_[level] + (from >> 6);
      const std::uint32_t end = level + 1 < depth_ ? levels_[level + 1] : static_cast<std::uint32_t>(words_.size());
      if (word >= end) return kNoState;
      if (const std::uint64_t rest = words_[word] >> (from & 63); rest != 0) {
        from += static_cast<std::uint32_t>(std::countr_zero(rest));
        for (; level > 0; --level)  // down to the member
          from = (from << 6) + static_cast<std::uint32_t>(std::countr_zero(words_[levels_[level - 1] + from]));
        return StateId{from};
      }
      from = (from >> 6) + 1;
    }
    return kNoState;
  }

 private:
  std::vector<std::uint64_t> words_;  // the members; then, level by level, a bit for each word of the level below
  std::array<std::uint32_t, 6> levels_ = {};  // where each level begins
  std::size_t depth_ = 0;
  std::uint32_t members_ = 0;
};

}  // namespace race::semantics
