// Numbers in the query of a request and in its path. Pure.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "core/value/expected.h"
#include "server/http/message.h"

namespace race::server {

struct NumberRange {
  std::int64_t least = 1, most = std::numeric_limits<std::int64_t>::max();
};

/// The whole number that `text` is in decimal digits; nothing: it is none, or too large.
std::optional<std::int64_t> whole_number(std::string_view text);

/// The whole number at `name` of the query; nothing: it is absent. Error `out_of_range`.
Expected<std::optional<std::int64_t>> query_number(const Request& request, std::string_view name,
                                                   NumberRange range = {});

/// The text at `name` of the query; empty: it is absent.
std::string query_text(const Request& request, std::string_view name);

}  // namespace race::server
