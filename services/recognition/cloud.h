// Cloud: what PCL does for recognition: voxel grids, the plane that things stand on, Euclidean clusters. Functions; any
// thread; the same points give the same answer.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace race::recognition {

/// Points in the camera's frame [m].
using Cloud = std::vector<std::array<float, 3>>;

/// normal . p = offset; the normal has length 1 and looks towards the camera, so the offset is negative.
struct Plane {
  std::array<double, 3> normal{};
  double offset = 0;

  double height(double x, double y, double z) const { return normal[0] * x + normal[1] * y + normal[2] * z - offset; }
};

/// One point for each cube of edge `leaf` [m] that has some: their mean.
Cloud voxels(const Cloud& cloud, float leaf);

/// The plane (RANSAC) that most points lie on, within `tolerance` [m]; none if less than `share` of them do.
std::optional<Plane> find_plane(const Cloud& cloud, double tolerance, double share);

/// Groups of at least `least` points, each nearer than `gap` [m] to another of its group; the largest first.
std::vector<Cloud> clusters(const Cloud& cloud, double gap, int least);

}  // namespace race::recognition
