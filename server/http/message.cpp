#include "server/http/message.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/language/primitives/utf8.h"

namespace race::server {
namespace {

// %41 -> A; in a query, + -> space. Nothing: badly encoded, a control character, or no UTF-8.
std::optional<std::string> decode(std::string_view text, bool query) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == '%') {
      unsigned value = 0;
      if (i + 2 >= text.size()) return std::nullopt;
      const auto [end, error] = std::from_chars(text.data() + i + 1, text.data() + i + 3, value, 16);
      if (error != std::errc() || end != text.data() + i + 3) return std::nullopt;
      c = static_cast<char>(value);
      i += 2;
    } else if (c == '+' && query) {
      c = ' ';
    }
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return std::nullopt;
    out += c;
  }
  if (!language::utf8::valid(out)) return std::nullopt;
  return out;
}

}  // namespace

std::string_view Request::header(std::string_view name) const {
  const auto found = std::ranges::find(headers, name, [](const auto& each) -> std::string_view { return each.first; });
  return found == headers.end() ? std::string_view() : found->second;
}

std::size_t Request::count(std::string_view name) const {
  return static_cast<std::size_t>(
      std::ranges::count(headers, name, [](const auto& each) -> std::string_view { return each.first; }));
}

Expected<std::pair<std::string, Parameters>> parse_target(std::string_view target) {
  const auto bad = [&] { return unexpected(ErrorCode::syntax, "the request target is no /path?query", ""); };
  if (target.empty() || target.front() != '/') return bad();
  const auto mark = target.find('?');
  const auto path = decode(target.substr(0, mark), false);
  if (!path) return bad();
  Parameters query;
  std::string_view rest = mark == std::string_view::npos ? std::string_view() : target.substr(mark + 1);
  while (!rest.empty()) {
    const auto end = rest.find('&');
    const std::string_view part = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    const auto equals = part.find('=');
    const auto name = decode(part.substr(0, equals), true);
    const auto value = decode(equals == std::string_view::npos ? "" : part.substr(equals + 1), true);
    if (!name || !value) return bad();
    if (!name->empty()) query.try_emplace(*name, *value);
  }
  return std::pair(*path, std::move(query));
}

}  // namespace race::server
