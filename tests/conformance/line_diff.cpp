#include "tests/conformance/line_diff.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <vector>

namespace race {
namespace {

constexpr std::size_t kContext = 3;

struct Line {
  char mark;  // ' ', '-' or '+'
  std::string text;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Both texts merged, by their longest common subsequence.
std::vector<Line> merged(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<std::vector<std::uint32_t>> common(a.size() + 1, std::vector<std::uint32_t>(b.size() + 1, 0));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      common[i][j] = a[i] == b[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
  std::vector<Line> lines;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      lines.push_back({' ', a[i++]});
      ++j;
    } else if (j == b.size() || (i < a.size() && common[i + 1][j] >= common[i][j + 1])) {
      lines.push_back({'-', a[i++]});
    } else {
      lines.push_back({'+', b[j++]});
    }
  }
  return lines;
}

// Whether a line differs, or is at most kContext lines away from one that does.
bool is_shown(const std::vector<Line>& lines, std::size_t at) {
  const std::size_t first = at - std::min(at, kContext);
  const std::size_t end = std::min(lines.size(), at + kContext + 1);
  return std::any_of(lines.begin() + static_cast<std::ptrdiff_t>(first),
                     lines.begin() + static_cast<std::ptrdiff_t>(end), [](const Line& l) { return l.mark != ' '; });
}

}  // namespace

std::string line_diff(const std::string& expected, const std::string& actual, std::size_t limit) {
  const std::vector<Line> lines = merged(lines_of(expected), lines_of(actual));
  std::string out;
  std::size_t shown = 0, last = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!is_shown(lines, i)) continue;
    if (shown++ == limit) return out + "... (more lines differ)\n";
    if (i > last) out += "...\n";
    out += lines[i].mark + lines[i].text + "\n";
    last = i + 1;
  }
  return out;
}

}  // namespace race
