#include "server/handlers/preconditions.h"

#include "server/handlers/query.h"

namespace race::server {

std::string tag_of(std::int64_t revision) { return "\"" + std::to_string(revision) + "\""; }

void add_tag(Reply& reply, std::int64_t revision) { reply.headers.emplace_back("ETag", tag_of(revision)); }

Expected<std::optional<std::int64_t>> if_match(const Request& request) {
  if (request.count("if-match") == 0) return std::nullopt;
  const std::string_view tag = request.header("if-match");
  const bool is_quoted = tag.size() > 2 && tag.front() == '"' && tag.back() == '"';
  const auto revision = is_quoted ? whole_number(tag.substr(1, tag.size() - 2)) : std::nullopt;
  if (request.count("if-match") > 1 || !revision || *revision < 1)
    return unexpected(ErrorCode::out_of_range, "must be one strong tag of a revision, such as \"3\"", "If-Match");
  return revision;
}

Expected<bool> requires_absence(const Request& request) {
  if (request.count("if-none-match") == 0) return false;
  if (request.count("if-none-match") == 1 && request.header("if-none-match") == "*") return true;
  return unexpected(ErrorCode::out_of_range, "must be * for a request that changes something", "If-None-Match");
}

}  // namespace race::server
