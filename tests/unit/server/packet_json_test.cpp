#include "server/stream/packet_json.h"

#include <gmock/gmock.h>

#include "core/value/json.h"

namespace race::server {
namespace {

services::Packet picture(std::int64_t width, std::int64_t height, std::size_t bytes) {
  services::Packet packet{2.5, Dict{{"encoding", "depth16_mm+rgb8"}, {"width", width}, {"height", height}}, {}};
  packet.header.freeze();
  packet.bytes.resize(bytes);
  return packet;
}

services::Packet picture(std::int64_t width, std::int64_t height) {
  return picture(width, height, static_cast<std::size_t>(width * height * 5));
}

TEST(PacketJson, HasTimeAndHeaderOfAnyPacket) {
  const services::Packet packet{1.5, Dict{{"encoding", "drops"}, {"count", 3}}, {std::byte{7}}};
  EXPECT_EQ(to_json(packet_json(packet)), R"({"time":1.5,"header":{"encoding":"drops","count":3}})");
}

TEST(PacketJson, LeavesASmallPictureAsItIs) {
  services::Packet packet = picture(2, 1);
  const unsigned char bytes[] = {0xE2, 0x04, 0, 0, 200, 10, 20, 0, 128, 255};
  for (std::size_t i = 0; i < sizeof bytes; ++i) packet.bytes[i] = std::byte{bytes[i]};
  EXPECT_EQ(to_json(*packet_json(packet).find("picture")),
            R"({"width":2,"height":1,"depth":"4gQAAA==","colour":"yAoUAID/"})");
}

// 640x2 pixels become 320x1: of the first square, one pixel was measured and one is white.
TEST(PacketJson, MakesALargePictureSmall) {
  services::Packet packet = picture(640, 2);
  packet.bytes[2 * 640] = std::byte{0x34};  // depth of the first pixel of the second row
  packet.bytes[2 * 640 + 1] = std::byte{0x12};
  for (std::size_t i = 0; i < 3; ++i) packet.bytes[640 * 2 * 2 + 3 + i] = std::byte{255};  // colour of the second pixel
  const Value json = packet_json(packet);
  const Value& small = *json.find("picture");
  EXPECT_EQ(small.find("width")->as_integer(), 320);
  EXPECT_EQ(small.find("height")->as_integer(), 1);
  EXPECT_EQ(small.find("depth")->as_string().substr(0, 4), "NBIA");       // 0x34 0x12 0
  EXPECT_EQ(small.find("colour")->as_string().substr(0, 8), "Pz8/AAAA");  // 255 / 4, three times
  EXPECT_EQ(small.find("depth")->as_string().size(), (320U * 2 + 2) / 3 * 4);
  EXPECT_EQ(small.find("colour")->as_string().size(), 320U * 3 / 3 * 4);
}

TEST(PacketJson, HasNoPictureWhereTheBytesAreNotAsTheHeaderSays) {
  EXPECT_NE(packet_json(picture(4, 2)).find("picture"), nullptr);
  for (const services::Packet& packet : {picture(4, 2, 39), picture(4, 2, 41), picture(0, 2, 0), picture(-4, -2, 40),
                                         picture(4097, 1), picture(std::int64_t{1} << 62, 4, 0)})
    EXPECT_EQ(packet_json(packet).find("picture"), nullptr) << to_json(packet.header);
}

TEST(PacketJson, HasNoPictureThatWouldHaveNoHeight) {
  EXPECT_EQ(packet_json(picture(641, 2)).find("picture"), nullptr);
  EXPECT_EQ(packet_json(picture(641, 3)).find("picture")->find("height")->as_integer(), 1);
}

}  // namespace
}  // namespace race::server
