#include "services/recognition/frame.h"

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

Expected<Frame> read_frame(const services::Packet& packet) {
  Frame frame;
  frame.time = packet.time;
  const Value* encoding = packet.header.find("encoding");
  if (!encoding || *encoding != Value(services::kDepthAndColour))
    return unexpected(ErrorCode::type, "expected " + std::string(services::kDepthAndColour), "encoding");
  ASSIGN_OR_RETURN(const double width, number(packet.header, "width", 1, kLargest));
  ASSIGN_OR_RETURN(const double height, number(packet.header, "height", 1, kLargest));
  ASSIGN_OR_RETURN(frame.fx, number(packet.header, "fx", 1, 1e5));
  ASSIGN_OR_RETURN(frame.fy, number(packet.header, "fy", 1, 1e5));
  ASSIGN_OR_RETURN(frame.cx, number(packet.header, "cx", 0, kLargest));
  ASSIGN_OR_RETURN(frame.cy, number(packet.header, "cy", 0, kLargest));
  frame.width = static_cast<int>(width);
  frame.height = static_cast<int>(height);
  const auto pixels = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
  if (packet.bytes.size() != pixels * 5)
    return unexpected(ErrorCode::type, "expected " + std::to_string(pixels * 5) + " bytes", "bytes");
  frame.depth_mm.resize(pixels);
  frame.colour.resize(pixels);
  std::memcpy(frame.depth_mm.data(), packet.bytes.data(), pixels * 2);
  std::memcpy(frame.colour.data(), packet.bytes.data() + pixels * 2, pixels * 3);
  return frame;
}

}  // namespace race::recognition
