#include "server/commands/near_word.h"

#include <algorithm>

#include "core/value/expected.h"

namespace race::server {
namespace {

constexpr std::size_t kMaxSlips = 2;

std::string_view without_dashes(std::string_view word) {
  word.remove_prefix(std::min(word.find_first_not_of('-'), word.size()));
  return word;
}

// Slips between two words: Levenshtein's distance, with an exchange of neighbours as one.
std::size_t slips(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& least = table[i][j];
      if (i == 0 || j == 0) {
        least = i + j;
        continue;
      }
      const std::size_t wrong = a[i - 1] == b[j - 1] ? 0 : 1;
      least = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1, table[i - 1][j - 1] + wrong});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) least = std::min(least, table[i - 2][j - 2] + 1);
    }
  }
  return table[a.size()][b.size()];
}

}  // namespace

std::string near_word(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string_view bare = without_dashes(word);
  std::size_t least = std::min(kMaxSlips, bare.size() / 3) + 1;
  std::string nearest;
  std::vector<std::string> continued;
  for (const std::string& candidate : candidates) {
    const std::string_view other = without_dashes(candidate);
    if (!bare.empty() && other.starts_with(bare)) continued.push_back(candidate);
    if (other.size() > bare.size() + kMaxSlips || bare.size() > other.size() + kMaxSlips) continue;
    const std::size_t count = slips(bare, other);
    if (count > least) continue;
    nearest = count < least ? candidate : "";
    least = count;
  }
  return continued.size() == 1 ? continued.front() : nearest;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string near = near_word(word, candidates);
  return near.empty() ? "" : "; did you mean " + quote(near) + "?";
}

}  // namespace race::server
