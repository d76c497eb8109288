// Pose: a frame seen from another one, as plain numbers, so that no room has to know another room's geometry library.
#pragma once

#include <array>

namespace race::world {

using Vec3 = std::array<double, 3>;

struct Pose {
  Vec3 position{};                                  // metres
  std::array<double, 4> orientation{0, 0, 0, 1.0};  // unit quaternion [qx, qy, qz, qw]
  bool operator==(const Pose&) const = default;
};

}  // namespace race::world
