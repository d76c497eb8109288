// Camera: the service `camera` (thesis, appendix A: KinectDriver): colour and depth pictures of the world, and their
// points, as two data flows. Operations, the flows' formats and limits: README.md.
//
// Threads: its group's, which is the world's: step() follows the world's step and records the poses. Pictures are
// rendered on a thread of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "services/camera/intrinsics.h"
#include "services/host/worker.h"
#include "services/table_component.h"
#include "services/world/world.h"

namespace race::camera {

/// The RSM of every camera.
const rsm::Service& model();

class Camera final : public services::TableComponent {
 public:
  /// Renders `world` from the camera of its scene, which must have one. All outlive the component. `seed` is that of
  /// the noise.
  Camera(services::ServiceHost& host, const world::World& world, std::uint64_t seed);

  static const services::OperationTable& operations();
  void step() override;
  void demand_changed(std::string_view flow, bool on) override;
  void stop() override { worker_.reset(); }

 private:
  void info(const services::Call& call);
  void take_picture();

  const world::World& world_;
  const world::CameraMount mount_;
  const Intrinsics intrinsics_ = kinect();
  std::uint64_t seed_;
  std::uint64_t pictures_ = 0;  // taken so far
  int under_way_ = 0;
  std::set<std::string, std::less<>> wanted_;  // flows with a subscriber
  services::Time next_ = 0;                    // picture
  std::unique_ptr<services::Worker> worker_;
};

}  // namespace race::camera
