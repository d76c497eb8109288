// What a client says of the person at it (schemas/stream_request.json, `presence`): which document they are at and what
// they do there. Pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

struct PresenceRequest {
  static constexpr std::size_t kMaxName = 40;           // code points
  static constexpr std::size_t kMaxSelection = 32;      // elements
  static constexpr std::size_t kMaxField = 128;         // code points of its name
  static constexpr std::int64_t kMaxOffset = 1 << 20U;  // in a text, in UTF-16 units, as pages count
  static constexpr double kMaxCoordinate = 1e6;

  std::string document;
  Value person;  // schemas/presence.json, `person`, without what the server adds
};

/// What is wrong with the message goes to `errors`; then the result is of no use.
PresenceRequest read_presence_request(const Value& message, std::vector<Error>& errors);

}  // namespace race::server
