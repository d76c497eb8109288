#include "services/camera/camera.h"

#include <cstring>

#include "services/camera/cloud.h"
#include "services/camera/noise.h"
#include "services/camera/view.h"
#include "services/encodings.h"

namespace race::camera {
namespace {

constexpr std::string_view kFrame = "frame", kCloud = "cloud";
// From exposure to delivery: one period of the sensor.
constexpr services::Time kLatency = 1.0 / 30;
// In real time pictures are left out rather than piled up.
constexpr int kMostUnderWay = 2;

Dict intrinsics_value(const Intrinsics& k) {
  return {{"width", k.width}, {"height", k.height}, {"fx", k.fx}, {"fy", k.fy}, {"cx", k.cx}, {"cy", k.cy}};
}

Dict pose_value(const world::Pose& pose) {
  return {{"position", List(pose.position.begin(), pose.position.end())},
          {"orientation", List(pose.orientation.begin(), pose.orientation.end())}};
}

services::PacketPtr to_frame(const Measurement& picture, const Intrinsics& intrinsics, const world::Pose& o_t_c,
                             services::Time time) {
  auto packet = std::make_shared<services::Packet>();
  packet->time = time;
  Dict header = intrinsics_value(intrinsics);
  header.set("o_t_c", pose_value(o_t_c));
  header.set("encoding", services::kDepthAndColour);
  header.set("time", time);
  packet->header = std::move(header);
  packet->header.freeze();
  static_assert(sizeof(Rgb) == 3);
  const std::size_t depth_bytes = picture.depth_mm.size() * 2, colour_bytes = picture.colour.size() * 3;
  packet->bytes.resize(depth_bytes + colour_bytes);
  std::memcpy(packet->bytes.data(), picture.depth_mm.data(), depth_bytes);
  std::memcpy(packet->bytes.data() + depth_bytes, picture.colour.data(), colour_bytes);
  return packet;
}

}  // namespace

Camera::Camera(services::ServiceHost& host, const world::World& world, std::uint64_t seed)
    : TableComponent(operations(), host), world_(world), mount_(world.scene().camera.value()), seed_(seed) {}

void Camera::info(const services::Call& call) {
  Dict info = intrinsics_value(intrinsics_);
  info.set("nearest", kKinectNearest);
  info.set("farthest", kKinectFarthest);
  info.set("rate_hz", mount_.rate_hz);
  host().result(call.id, std::move(info));
}

void Camera::demand_changed(std::string_view flow, bool on) {
  if (flow != kFrame && flow != kCloud) return;
  if (wanted_.empty()) next_ = host().now();
  if (on)
    wanted_.emplace(flow);
  else
    wanted_.erase(std::string(flow));
  if (on && !worker_) worker_ = std::make_unique<services::Worker>(host());
}

void Camera::step() {
  constexpr services::Time kTolerance = 5e-7;
  const services::Time now = host().now();
  if (wanted_.empty() || now < next_ - kTolerance) return;
  next_ += 1 / mount_.rate_hz;
  if (next_ < now) next_ = now;
  if (under_way_ < kMostUnderWay) take_picture();
}

void Camera::take_picture() {
  ++under_way_;
  const services::Time time = host().now();
  // Each picture has noise of its own; seeds of neighbouring runs must not give each other's pictures.
  const std::uint64_t seed = seed_ * 0xD1342543DE82EF95U + ++pictures_;
  worker_->submit(time + kLatency, [this, time, seed, with_frame = wanted_.contains(kFrame),
                                    with_cloud = wanted_.contains(kCloud), items = view(world_, mount_.o_t_c)] {
    const Measurement picture = measure(rasterize(items, intrinsics_), seed);
    services::PacketPtr frame, cloud;
    if (with_frame) frame = to_frame(picture, intrinsics_, mount_.o_t_c, time);
    if (with_cloud) cloud = to_cloud(picture, intrinsics_, time);
    return [this, frame = std::move(frame), cloud = std::move(cloud)] {
      --under_way_;
      if (frame && wanted_.contains(kFrame)) host().publish(kFrame, frame);
      if (cloud && wanted_.contains(kCloud)) host().publish(kCloud, cloud);
    };
  });
}

}  // namespace race::camera
