#include "services/recognition/rgbd_image.h"

#include <cmath>
#include <cstring>

#include "services/encodings.h"

namespace race::recognition {
namespace {

constexpr double kLargest = 4096;  // pixels along an edge

Expected<double> number(const Value& header, std::string_view key, double least, double most) {
  const Value* value = header.find(key);
  if (!value) return unexpected(ErrorCode::missing, "the header has no such field", std::string(key));
  if (!value->is_numeric()) return unexpected(ErrorCode::type, "expected a number", std::string(key));
  const double number = value->to_double();
  if (!(number >= least && number <= most))
    return unexpected(ErrorCode::out_of_range, "out of range", std::string(key));
  return number;
}

}  // namespace

Expected<RgbdImage> read_rgbd_image(const services::Packet& packet) {
  RgbdImage image;
  image.time = packet.time;
  const Value* encoding = packet.header.find("encoding");
  if (!encoding || *encoding != Value(services::kDepthAndColour))
    return unexpected(ErrorCode::type, "expected " + std::string(services::kDepthAndColour), "encoding");
  ASSIGN_OR_RETURN(const double width, number(packet.header, "width", 1, kLargest));
  ASSIGN_OR_RETURN(const double height, number(packet.header, "height", 1, kLargest));
  ASSIGN_OR_RETURN(image.fx, number(packet.header, "fx", 1, 1e5));
  ASSIGN_OR_RETURN(image.fy, number(packet.header, "fy", 1, 1e5));
  ASSIGN_OR_RETURN(image.cx, number(packet.header, "cx", 0, kLargest));
  ASSIGN_OR_RETURN(image.cy, number(packet.header, "cy", 0, kLargest));
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (packet.bytes.size() != pixels * 5)
    return unexpected(ErrorCode::type, "expected " + std::to_string(pixels * 5) + " bytes", "bytes");
  image.depth_mm.resize(pixels);
  image.colour.resize(pixels);
  std::memcpy(image.depth_mm.data(), packet.bytes.data(), pixels * 2);
  std::memcpy(image.colour.data(), packet.bytes.data() + pixels * 2, pixels * 3);
  return image;
}

}  // namespace race::recognition
