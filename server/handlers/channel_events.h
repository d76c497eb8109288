// Routes that give a channel of the stream as Server-Sent Events. Pure.
#pragma once

#include <string>

#include "server/handlers/handlers.h"

namespace race::server {

/// Follows the channel, from what the client has already (Last-Event-ID: the number of a message). Errors: `rights`:
/// who asks may not subscribe to it; `out_of_range`: that is no number.
Handled channel_events(const Request& request, std::string channel);

}  // namespace race::server
