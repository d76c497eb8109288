// Content codings (RFC 9110, 8.4 and 12.5.3): in which form a client wants the body of an answer.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "server/http/message.h"

namespace race::server {

/// The one of `codings` ("br", "gzip", "identity"), which are in order of our preference, that the client's
/// Accept-Encoding gives the greatest weight; nothing: it accepts none. Without the header only "identity" is accepted;
/// with one that does not name it, it is the last resort. What has no valid form in the header is ignored.
std::optional<std::string_view> choose_coding(const Request& request, std::span<const std::string_view> codings);

}  // namespace race::server
