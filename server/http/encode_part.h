// encode_part: texts in the paths and queries of requests.
//
// Threads: any.
#pragma once

#include <string>
#include <string_view>

namespace race::server {

/// `text` as one part of the path of a request target, or of its query: all but letters, digits and `-._~` as %2F.
std::string encode_part(std::string_view text);

}  // namespace race::server
