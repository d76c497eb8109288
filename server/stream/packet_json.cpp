#include "server/stream/packet_json.h"

#include "core/value/base64.h"
#include "server/stream/small_picture.h"

namespace race::server {

Value packet_json(const services::Packet& packet) {
  Dict whole{{"time", packet.time}, {"header", packet.header}};
  if (const auto picture = small_picture(packet))
    whole.set("picture", Dict{{"width", static_cast<std::int64_t>(picture->width)},
                              {"height", static_cast<std::int64_t>(picture->height)},
                              {"depth", base64(picture->depth)},
                              {"colour", base64(picture->colour)}});
  Value json = std::move(whole);
  return std::move(json.freeze());
}

}  // namespace race::server
