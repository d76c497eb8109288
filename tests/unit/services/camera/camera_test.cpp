// The camera of the demonstrator's cell: what it shows, when, and to whom.
#include "services/camera/camera.h"

#include <gmock/gmock.h>

#include <cstring>

#include "tests/unit/services/host/bench.h"

namespace race::camera {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A cell with a camera alone; its world stands still, so that only the camera makes a difference.
struct CameraCell {
  explicit CameraCell(std::uint64_t seed = 1)
      : world(world::World::load(RACE_SOURCE_DIR "/deploy/demo/scene.json").value()) {
    auto& service = bench.host.declare("camera", "KinectDriver", bench.queue);
    bench.host.attach("camera", std::make_unique<Camera>(service, *world, seed));
  }
  ~CameraCell() { bench.host.stop(); }
  services::Flows::WatchId watch(const char* flow = "frame") {
    return bench.host.watch("camera", flow, [this](const services::PacketPtr& packet) {
      packets.push_back(packet);
      arrivals.push_back(bench.milliseconds);
    });
  }
  services::Bench bench;
  std::unique_ptr<world::World> world;
  std::vector<services::PacketPtr> packets;
  std::vector<int> arrivals;
};

std::uint16_t depth_mm(const services::Packet& packet, int u, int v) {
  std::uint16_t mm = 0;
  std::memcpy(&mm, packet.bytes.data() + 2 * (v * 640 + u), 2);
  return mm;
}

TEST(Camera, TakesNoPictureWhileNobodyListens) {
  CameraCell cell;
  cell.bench.pass(1);
  const auto watch = cell.watch();
  cell.bench.pass(0.25);
  const auto seen = cell.packets.size();
  EXPECT_GE(seen, 2U);
  cell.bench.host.unwatch(watch);
  cell.bench.pass(0.5);
  cell.watch();
  cell.bench.pass(0.001);  // the first picture is on its way, and none of the time before
  EXPECT_EQ(cell.packets.size(), seen);
}

TEST(Camera, TakesPicturesAtTheRateOfTheSceneAndDeliversThemAPeriodLater) {
  CameraCell cell;
  cell.watch();
  cell.bench.pass(0.3);
  ASSERT_THAT(cell.arrivals, ElementsAre(35, 135, 235));
  EXPECT_NEAR(cell.packets[1]->time - cell.packets[0]->time, 0.1, 0.0015);
  EXPECT_EQ(cell.packets[1]->header.find("time")->as_number(), cell.packets[1]->time);
}

TEST(Camera, ShowsTheWorldAsItIs) {
  CameraCell cell;
  cell.watch();
  cell.bench.pass(0.05);
  ASSERT_EQ(cell.packets.size(), 1U);
  const services::Packet& packet = *cell.packets[0];
  EXPECT_EQ(packet.header.find("encoding")->as_string(), "depth16_mm+rgb8");
  ASSERT_EQ(packet.bytes.size(), 640U * 480U * 5U);
  // Where it stands, so that a reader of the picture alone knows where its points are.
  const auto& mount = cell.world->scene().camera->o_t_c;
  const Value* o_t_c = packet.header.find("o_t_c");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(o_t_c->find("position")->as_list()[i].to_double(), mount.position[i]);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(o_t_c->find("orientation")->as_list()[i].to_double(), mount.orientation[i]);
  // The scene's camera looks from 0.9 m above at 45 degrees: at the table, here free of parts.
  const double z = 0.9 * std::numbers::sqrt2;
  double sum = 0;
  for (int u = 310; u < 330; ++u) sum += depth_mm(packet, u, 350) / 20.0;
  const double row = (350 - packet.header.find("cy")->to_double()) / packet.header.find("fy")->to_double();
  EXPECT_NEAR(sum / 1000, z / (1 + row), 0.002);
}

TEST(Camera, ACloudHasThePointsOfThePictureAndNoOthers) {
  CameraCell cell;
  cell.watch("frame");
  cell.watch("cloud");
  cell.bench.pass(0.05);
  ASSERT_EQ(cell.packets.size(), 2U);
  const services::Packet &frame = *cell.packets[0], &cloud = *cell.packets[1];
  EXPECT_EQ(cloud.time, frame.time);
  const auto number = [&](const char* name) { return frame.header.find(name)->to_double(); };
  std::size_t point = 0;
  const auto points = static_cast<std::size_t>(cloud.header.find("points")->as_integer());
  ASSERT_EQ(cloud.bytes.size(), points * 15);
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      const double z = depth_mm(frame, u, v) / 1000.0;
      if (z == 0) continue;
      ASSERT_LT(point, points);
      float xyz[3];
      std::memcpy(xyz, cloud.bytes.data() + 12 * point, 12);
      ASSERT_NEAR(xyz[0], (u - number("cx")) / number("fx") * z, 1e-6);
      ASSERT_NEAR(xyz[1], (v - number("cy")) / number("fy") * z, 1e-6);
      ASSERT_NEAR(xyz[2], z, 1e-6);
      const std::byte* pixel = frame.bytes.data() + 640 * 480 * 2 + 3 * (640 * v + u);
      ASSERT_EQ(std::memcmp(cloud.bytes.data() + 12 * points + 3 * point, pixel, 3), 0);
      ++point;
    }
  }
  EXPECT_EQ(point, points);
}

TEST(Camera, MakesNoCloudForWhoWantsAPictureNorTheOtherWayRound) {
  for (const char* flow : {"frame", "cloud"}) {
    CameraCell cell;
    cell.watch(flow);
    cell.bench.pass(0.05);
    ASSERT_EQ(cell.packets.size(), 1U);
    EXPECT_EQ(cell.packets[0]->header.find("points") != nullptr, flow == std::string("cloud"));
  }
}

TEST(Camera, GivesTheSamePicturesForTheSameSeedOnly) {
  const auto pictures = [](std::uint64_t seed) {
    CameraCell cell(seed);
    cell.watch();
    cell.bench.pass(0.15);
    std::vector<std::vector<std::byte>> all;
    for (const auto& packet : cell.packets) all.push_back(packet->bytes);
    return all;
  };
  const auto first = pictures(7);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_NE(first[0], first[1]) << "noise of its own in each picture";
  EXPECT_EQ(first, pictures(7));
  EXPECT_NE(first, pictures(8));
}

TEST(Camera, TellsItsPinholeAndRange) {
  CameraCell cell;
  cell.bench.call("camera", "info");
  ASSERT_EQ(cell.bench.deliveries.size(), 1U);
  const Value& info = cell.bench.deliveries[0].data;
  EXPECT_EQ(info.find("width")->to_double(), 640);
  // 57 degrees across 640 pixels
  EXPECT_NEAR(2 * std::atan(320 / info.find("fx")->to_double()) * 180 / M_PI, 57, 1e-9);
  EXPECT_NEAR(2 * std::atan(240 / info.find("fy")->to_double()) * 180 / M_PI, 43, 1e-9);
  EXPECT_EQ(info.find("nearest")->to_double(), 0.8);
  EXPECT_THAT(cell.bench.violations("camera"), IsEmpty());
  cell.bench.call("camera", "info", {Value(1)});
  EXPECT_EQ(cell.bench.violations("camera").size(), 1U) << "an argument too many";
}

}  // namespace
}  // namespace race::camera
