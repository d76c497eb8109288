#include "server/handlers/query.h"

#include <charconv>

namespace race::server {

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || text.front() == '-') return std::nullopt;
  return number;
}

Expected<std::optional<std::int64_t>> query_number(const Request& request, std::string_view name, NumberRange range) {
  const auto found = request.query.find(name);
  if (found == request.query.end()) return std::nullopt;
  const auto number = whole_number(found->second);
  if (number && *number >= range.least && *number <= range.most) return number;
  std::string what = "must be a whole number from " + std::to_string(range.least);
  if (range.most != NumberRange{}.most) what += " to " + std::to_string(range.most);
  return unexpected(ErrorCode::out_of_range, std::move(what), std::string(name));
}

std::string query_text(const Request& request, std::string_view name) {
  const auto found = request.query.find(name);
  return found == request.query.end() ? std::string() : found->second;
}

}  // namespace race::server
