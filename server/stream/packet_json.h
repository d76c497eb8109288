// Packets of data flows as browsers get them: the header as it is, and pictures small enough for many watchers.
#pragma once

#include "core/value/value.h"
#include "services/component.h"

namespace race::server {

/// schemas/packet.json, frozen. A picture ("depth16_mm+rgb8", services/camera) is made at most 320 pixels wide: of each
/// square of pixels the mean colour and the first depth that was measured. Bytes of another encoding, or that are not
/// as the header says, stay away, and a picture that is lower than one square.
Value packet_json(const services::Packet& packet);

}  // namespace race::server
