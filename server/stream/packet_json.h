// Packets of data flows as browsers get them: the header as it is, and pictures made small.
#pragma once

#include "core/value/value.h"
#include "services/component.h"

namespace race::server {

/// schemas/packet.json, frozen, with its small_picture(). Bytes of which there is none stay away.
Value packet_json(const services::Packet& packet);

}  // namespace race::server
