// Conditions of a request on the document that it is about (RFC 9110, section 13): its last revision is its entity tag.
// Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/value/expected.h"
#include "server/http/message.h"

namespace race::server {

/// The strong tag of a revision, such as "3" with its quotation marks.
std::string tag_of(std::int64_t revision);
/// The header ETag. The answer is not stored by caches all the same: it also says what today's rules find.
void add_tag(Reply& reply, std::int64_t revision);

/// The revision of If-Match, one strong tag; nothing: the header is absent. Error `out_of_range`.
Expected<std::optional<std::int64_t>> if_match(const Request& request);

/// Whether If-None-Match is `*`: the document must not be there yet. Error `out_of_range`: it is something else.
Expected<bool> requires_absence(const Request& request);

}  // namespace race::server
