#include "services/camera/cloud.h"

#include <array>
#include <cstring>

#include "services/encodings.h"

namespace race::camera {

services::PacketPtr to_cloud(const Measurement& picture, const Intrinsics& k, services::Time time) {
  std::vector<std::array<float, 3>> points;
  std::vector<Rgb> colours;
  const std::size_t width = static_cast<std::size_t>(picture.width);
  for (std::size_t i = 0; i < picture.depth_mm.size(); ++i) {
    if (picture.depth_mm[i] == 0) continue;
    const double z = picture.depth_mm[i] / 1000.0;
    const double u = static_cast<double>(i % width), v = static_cast<double>(i / width);
    points.push_back(
        {static_cast<float>((u - k.cx) / k.fx * z), static_cast<float>((v - k.cy) / k.fy * z), static_cast<float>(z)});
    colours.push_back(picture.colour[i]);
  }
  auto packet = std::make_shared<services::Packet>();
  packet->time = time;
  packet->header = Dict{
      {"points", static_cast<std::int64_t>(points.size())}, {"encoding", services::kPointsAndColour}, {"time", time}};
  packet->header.freeze();
  static_assert(sizeof(Rgb) == 3 && sizeof(points[0]) == 12);
  packet->bytes.resize(points.size() * (12 + 3));
  std::memcpy(packet->bytes.data(), points.data(), points.size() * 12);
  std::memcpy(packet->bytes.data() + points.size() * 12, colours.data(), colours.size() * 3);
  return packet;
}

}  // namespace race::camera
