#include "server/stream/packet_json.h"

#include <optional>
#include <string>

#include "core/value/base64.h"
#include "services/encodings.h"

namespace race::server {
namespace {

constexpr std::size_t kWidth = 320;
constexpr std::int64_t kMostPixels = 4096;  // along a side

struct Picture {
  std::size_t width, height;
  std::size_t shrink;       // side of the squares that become one pixel
  const std::byte* depth;   // 2 bytes for each pixel
  const std::byte* colour;  // 3
};

std::optional<std::size_t> side(const Value& header, std::string_view name) {
  const Value* value = header.find(name);
  if (!value || !value->is_integer() || value->as_integer() < 1 || value->as_integer() > kMostPixels)
    return std::nullopt;
  return static_cast<std::size_t>(value->as_integer());
}

std::optional<Picture> picture_of(const services::Packet& packet) {
  const Value* encoding = packet.header.find("encoding");
  if (!encoding || *encoding != Value(services::kDepthAndColour)) return std::nullopt;
  const auto width = side(packet.header, "width"), height = side(packet.header, "height");
  if (!width || !height || packet.bytes.size() != *width * *height * 5) return std::nullopt;
  const std::size_t shrink = (*width + kWidth - 1) / kWidth;
  if (*height < shrink) return std::nullopt;
  return Picture{*width, *height, shrink, packet.bytes.data(), packet.bytes.data() + *width * *height * 2};
}

/// The square of `side` x `side` pixels whose top left is (u, v).
struct Square {
  std::size_t u, v, side;
};

void add_depth(const Picture& picture, const Square& square, std::string& to) {
  for (std::size_t i = 0; i < square.side * square.side; ++i) {
    const std::size_t row = square.v + i / square.side, column = square.u + i % square.side;
    const std::byte* pixel = picture.depth + 2 * (row * picture.width + column);
    const bool measured = pixel[0] != std::byte{0} || pixel[1] != std::byte{0};
    if (!measured && i + 1 < square.side * square.side) continue;
    to += {static_cast<char>(pixel[0]), static_cast<char>(pixel[1])};
    return;
  }
}

void add_colour(const Picture& picture, const Square& square, std::string& to) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::size_t sum = 0;
    for (std::size_t row = square.v; row < square.v + square.side; ++row)
      for (std::size_t column = square.u; column < square.u + square.side; ++column)
        sum += std::to_integer<std::size_t>(picture.colour[3 * (row * picture.width + column) + channel]);
    to += static_cast<char>(sum / (square.side * square.side));
  }
}

Dict picture_json(const Picture& picture) {
  const std::size_t shrink = picture.shrink, width = picture.width / shrink, height = picture.height / shrink;
  std::string depth, colour;
  depth.reserve(width * height * 2);
  colour.reserve(width * height * 3);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      const Square square{column * shrink, row * shrink, shrink};
      add_depth(picture, square, depth);
      add_colour(picture, square, colour);
    }
  }
  return {{"width", static_cast<std::int64_t>(width)},
          {"height", static_cast<std::int64_t>(height)},
          {"depth", base64(depth)},
          {"colour", base64(colour)}};
}

}  // namespace

Value packet_json(const services::Packet& packet) {
  Dict whole{{"time", packet.time}, {"header", packet.header}};
  if (const auto picture = picture_of(packet)) whole.set("picture", picture_json(*picture));
  Value json = std::move(whole);
  return std::move(json.freeze());
}

}  // namespace race::server
