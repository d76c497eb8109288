// Header fields whose value is a list (RFC 9110, 5.6.1).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"

namespace race::server {

/// Without spaces and tabs at its ends.
std::string_view trim(std::string_view text);

/// In lower case, as far as it is ASCII: of what header fields do not distinguish.
std::string lower(std::string_view text);

/// The elements of the header `name`, trimmed, of all its lines in their order; empty ones are left out. Views of
/// `request`.
std::vector<std::string_view> elements_of(const Request& request, std::string_view name);

/// Whether the client has what bears the entity tag: If-None-Match lists it, compared weakly, or is `*` (13.1.2).
bool if_none_match_lists(const Request& request, std::string_view tag);

}  // namespace race::server
