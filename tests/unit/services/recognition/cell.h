// The demonstrator's cell as the camera sees it, with parts put where a test wants them: what recognition is held
// against.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "services/camera/noise.h"
#include "services/camera/view.h"
#include "services/recognition/recognize.h"
#include "services/world/world.h"

namespace race::recognition {

inline std::vector<Part> demo_parts() {
  auto parts = load_parts(RACE_SOURCE_DIR "/deploy/demo/parts.json");
  EXPECT_TRUE(parts) << to_string(parts.error());
  return *parts;
}

inline world::Scene demo_scene() { return world::load_scene(RACE_SOURCE_DIR "/deploy/demo/scene.json").value(); }

/// The world of a scene, at rest since the start.
inline std::unique_ptr<world::World> build(const world::Scene& scene) {
  return world::World::create(scene, world::load_urdf(scene.robot.urdf).value()).value();
}

inline world::Body& body(world::Scene& scene, const std::string& name) {
  for (world::Body& each : scene.bodies)
    if (each.name == name) return each;
  throw std::out_of_range(name);
}

/// A turn about the world's z axis [rad].
inline std::array<double, 4> yaw(double angle) { return {0, 0, std::sin(angle / 2), std::cos(angle / 2)}; }

/// What a Kinect measures of these things.
inline RgbdImage measured(const std::vector<camera::Item>& items, std::uint64_t seed) {
  const camera::Intrinsics k = camera::kinect();
  const auto picture = camera::measure(camera::rasterize(items, k), seed);
  RgbdImage image{0, k.width, k.height, k.fx, k.fy, k.cx, k.cy, picture.depth_mm, {}};
  for (const camera::Rgb& c : picture.colour) image.colour.push_back({c.r, c.g, c.b});
  return image;
}

/// What the camera measures of the world now.
inline RgbdImage measured(const world::World& world, std::uint64_t seed) {
  return measured(camera::view(world, world.scene().camera->o_t_c), seed);
}

inline std::vector<std::string> labels_in(const std::vector<Detection>& detections) {
  std::vector<std::string> labels;
  for (const Detection& detection : detections) labels.push_back(detection.label);
  return labels;
}

}  // namespace race::recognition
