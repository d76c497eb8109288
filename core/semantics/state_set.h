// StateSet: a set of states, walked in tree order while it changes. A bitmap with summaries: adding is O(1), finding
// the next one is a few words, however large the model is.
#pragma once

#include <algorithm>
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

  // OPTIMIZATION: the lowest level is done in line; most changes end there.
  void add(StateId s) {
    std::uint64_t& word = words_[index(s) >> 6];
    const std::uint64_t before = word;
    word |= bit(index(s));
    last_ = members_ == 0 ? index(s) : std::max(last_, index(s));
    members_ += word != before ? 1 : 0;
    if (before == 0 && depth_ > 1) add_summaries(index(s) >> 6);
  }

  void remove(StateId s) {
    std::uint64_t& word = words_[index(s) >> 6];
    const std::uint64_t before = word;
    word &= ~bit(index(s));
    members_ -= word != before ? 1 : 0;
    if (word == 0 && depth_ > 1) remove_summaries(index(s) >> 6);
  }

  bool empty() const { return members_ == 0; }

  /// The first member from number `from` on; kNoState if there is none.
  StateId next(std::uint32_t from) const {
    if (members_ == 0 || from > last_) return kNoState;
    if (const std::uint64_t rest = words_[from >> 6] >> (from & 63); rest != 0)
      return StateId{from + static_cast<std::uint32_t>(std::countr_zero(rest))};
    return depth_ > 1 ? next_by_summaries(from) : kNoState;
  }

 private:
  static std::uint64_t bit(std::uint32_t i) { return std::uint64_t{1} << (i & 63); }

  // Word `i` of the lowest level has got its first member, or lost its last.
  [[gnu::noinline]] void add_summaries(std::uint32_t i) {
    for (std::size_t level = 1; level < depth_; ++level, i >>= 6) {
      std::uint64_t& word = words_[levels_[level] + (i >> 6)];
      const std::uint64_t before = word;
      word |= bit(i);
      if (before != 0) return;  // the summaries have this word already
    }
  }
  [[gnu::noinline]] void remove_summaries(std::uint32_t i) {
    for (std::size_t level = 1; level < depth_; ++level, i >>= 6) {
      std::uint64_t& word = words_[levels_[level] + (i >> 6)];
      word &= ~bit(i);
      if (word != 0) return;
    }
  }
  [[gnu::noinline]] StateId next_by_summaries(std::uint32_t from) const {
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

  std::vector<std::uint64_t> words_;  // the members; then, level by level, a bit for each word of the level below
  std::array<std::uint32_t, 6> levels_ = {};  // where each level begins
  std::size_t depth_ = 0;
  std::uint32_t members_ = 0;
  std::uint32_t last_ = 0;  // no member has a greater number
};

}  // namespace race::semantics
