#include "core/rcm/call_text.h"

#include <set>

#include "core/value/fields.h"

namespace race::rcm {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// The position after the string that starts at `at`, single or triple quoted; npos if it does not end.
std::size_t after_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string triple(3, quote);
  const std::string end = text.substr(at, 3) == triple ? triple : std::string(1, quote);
  for (std::size_t i = at + end.size(); i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
    } else if (text.substr(i, end.size()) == end) {
      return i + end.size();
    }
  }
  return std::string_view::npos;
}

/// The arguments between the opening bracket before `at` and its closing one; `at` is moved behind that. Nothing if it
/// does not close.
std::optional<std::vector<std::string_view>> split(std::string_view text, std::size_t& at) {
  std::vector<std::string_view> out;
  std::size_t start = at;
  int depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = after_string(text, at);
      if (at == std::string_view::npos) return std::nullopt;
      continue;
    }
    if (c == '#') return std::nullopt;
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (depth == 0 && (c == ',' || c == ')')) {
      out.push_back(trimmed(text.substr(start, at - start)));
      start = at + 1;
    }
    ++at;
    if (depth == 0 && c == ')') return out;
    if (c == ')' || c == ']' || c == '}') --depth;
  }
  return std::nullopt;
}

CallText::Argument argument(std::string_view text) {
  const auto equals = text.find('=');
  if (equals == std::string_view::npos || equals + 1 == text.size() || text[equals + 1] == '=')
    return {"", std::string(text)};
  const std::string_view keyword = trimmed(text.substr(0, equals));
  if (!is_name(keyword)) return {"", std::string(text)};
  return {std::string(keyword), std::string(trimmed(text.substr(equals + 1)))};
}

bool in_order(const std::vector<CallText::Argument>& arguments) {
  std::set<std::string_view> keywords;
  for (const auto& [keyword, expression] : arguments) {
    if (expression.empty() || (keyword.empty() && !keywords.empty())) return false;
    if (!keyword.empty() && !keywords.insert(keyword).second) return false;
  }
  return true;
}

}  // namespace

std::optional<CallText> parse_call(std::string_view text) {
  text = trimmed(text);
  const auto open = text.find('(');
  if (open == std::string_view::npos) return std::nullopt;
  const std::string_view target = trimmed(text.substr(0, open));
  const auto dot = target.rfind('.');
  if (!target.starts_with("svc.") || dot < 4) return std::nullopt;
  CallText out{std::string(target.substr(4, dot - 4)), std::string(target.substr(dot + 1)), {}};
  if (!is_name(out.service) || !is_name(out.operation)) return std::nullopt;
  std::size_t at = open + 1;
  auto arguments = split(text, at);
  if (!arguments || at != text.size()) return std::nullopt;
  if (arguments->back().empty()) arguments->pop_back();  // `f()` and `f(a,)`
  for (const std::string_view part : *arguments) out.arguments.push_back(argument(part));
  if (!in_order(out.arguments)) return std::nullopt;
  return out;
}

}  // namespace race::rcm
