#include "server/handlers/preconditions.h"

#include <algorithm>

#include "server/handlers/query.h"

namespace race::server {

std::string tag_of(std::int64_t revision) { return "\"" + std::to_string(revision) + "\""; }

void add_tag(Reply& reply, std::int64_t revision) {
  reply.headers.emplace_back("ETag", tag_of(revision));
  reply.headers.emplace_back("Cache-Control", "no-cache");
}

Expected<std::optional<std::int64_t>> if_match(const Request& request) {
  if (request.count("if-match") == 0) return std::nullopt;
  const std::string_view tag = request.header("if-match");
  const bool is_quoted = tag.size() > 2 && tag.front() == '"' && tag.back() == '"';
  const auto revision = is_quoted ? whole_number(tag.substr(1, tag.size() - 2)) : std::nullopt;
  if (request.count("if-match") > 1 || !revision || *revision < 1)
    return unexpected(ErrorCode::out_of_range, "must be one strong tag of a revision, such as \"3\"", "If-Match");
  return revision;
}

Expected<bool> if_none(const Request& request) {
  if (request.count("if-none-match") == 0) return false;
  if (request.count("if-none-match") == 1 && request.header("if-none-match") == "*") return true;
  return unexpected(ErrorCode::out_of_range, "must be * for a request that changes something", "If-None-Match");
}

bool has_tag(const Request& request, std::int64_t revision) {
  const std::string wanted = tag_of(revision);
  for (const auto& [name, value] : request.headers) {
    if (name != "if-none-match") continue;
    if (value == "*") return true;
    // The tags of revisions have no comma within them.
    for (std::string_view rest = value; !rest.empty();) {
      const auto comma = rest.find(',');
      std::string_view tag = rest.substr(0, comma);
      rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
      tag.remove_prefix(std::min(tag.find_first_not_of(" \t"), tag.size()));
      tag = tag.substr(0, tag.find_last_not_of(" \t") + 1);
      if (tag.starts_with("W/")) tag.remove_prefix(2);
      if (tag == wanted) return true;
    }
  }
  return false;
}

}  // namespace race::server
