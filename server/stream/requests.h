// What a client says on the stream (schemas/stream_request.json).
#pragma once

#include <memory>
#include <string_view>

#include "server/stream/displays.h"
#include "server/stream/hub.h"

namespace race::server {

/// Does what the message asks for, or tells the client why not.
void handle_stream_request(std::string_view message, const std::shared_ptr<Subscriber>& subscriber, Hub& hub,
                           Displays& displays);

}  // namespace race::server
