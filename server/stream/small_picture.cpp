#include "server/stream/small_picture.h"

#include "services/encodings.h"

namespace race::server {
namespace {

constexpr std::int64_t kMostPixels = 4096;  // along a side

struct RawPicture {
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

std::optional<RawPicture> picture_of(const services::Packet& packet) {
  const Value* encoding = packet.header.find("encoding");
  if (!encoding || *encoding != Value(services::kDepthAndColour)) return std::nullopt;
  const auto width = side(packet.header, "width"), height = side(packet.header, "height");
  if (!width || !height || packet.bytes.size() != *width * *height * 5) return std::nullopt;
  const std::size_t shrink = (*width + SmallPicture::kMostWidth - 1) / SmallPicture::kMostWidth;
  if (*height < shrink) return std::nullopt;
  return RawPicture{*width, *height, shrink, packet.bytes.data(), packet.bytes.data() + *width * *height * 2};
}

/// The square of `side` x `side` pixels whose top left is (u, v).
struct Square {
  std::size_t u, v, side;
};

void add_depth(const RawPicture& picture, const Square& square, std::string& to) {
  for (std::size_t i = 0; i < square.side * square.side; ++i) {
    const std::size_t row = square.v + i / square.side, column = square.u + i % square.side;
    const std::byte* pixel = picture.depth + 2 * (row * picture.width + column);
    const bool measured = pixel[0] != std::byte{0} || pixel[1] != std::byte{0};
    if (!measured && i + 1 < square.side * square.side) continue;
    to += {static_cast<char>(pixel[0]), static_cast<char>(pixel[1])};
    return;
  }
}

void add_colour(const RawPicture& picture, const Square& square, std::string& to) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::size_t sum = 0;
    for (std::size_t row = square.v; row < square.v + square.side; ++row)
      for (std::size_t column = square.u; column < square.u + square.side; ++column)
        sum += std::to_integer<std::size_t>(picture.colour[3 * (row * picture.width + column) + channel]);
    to += static_cast<char>(sum / (square.side * square.side));
  }
}

}  // namespace

std::optional<SmallPicture> small_picture(const services::Packet& packet) {
  const auto raw = picture_of(packet);
  if (!raw) return std::nullopt;
  SmallPicture small{raw->width / raw->shrink, raw->height / raw->shrink, {}, {}};
  small.depth.reserve(small.width * small.height * 2);
  small.colour.reserve(small.width * small.height * 3);
  for (std::size_t row = 0; row < small.height; ++row) {
    for (std::size_t column = 0; column < small.width; ++column) {
      const Square square{column * raw->shrink, row * raw->shrink, raw->shrink};
      add_depth(*raw, square, small.depth);
      add_colour(*raw, square, small.colour);
    }
  }
  return small;
}

}  // namespace race::server
