#include "services/camera/mesh.h"

#include <cmath>
#include <numbers>

namespace race::camera {
namespace {

constexpr int kAround = 48;  // corners of a circle

using Grid = std::vector<std::vector<Vec3>>;

void add_quad(std::vector<Triangle>& out, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  out.push_back({a, b, c});
  out.push_back({a, c, d});
}

std::vector<Triangle> box(const Vec3& size) {
  const auto corner = [&](int i) {
    return Vec3{(i & 1 ? 0.5 : -0.5) * size[0], (i & 2 ? 0.5 : -0.5) * size[1], (i & 4 ? 0.5 : -0.5) * size[2]};
  };
  // Of each face its corners, counter-clockwise from outside; bit 0 is x, 1 y, 2 z.
  constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  std::vector<Triangle> out;
  for (const auto& face : kFaces) add_quad(out, corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]));
  return out;
}

/// Rings of kAround corners about z, from the bottom to the top; a ring of radius 0 is a pole.
std::vector<Triangle> turned(const std::vector<std::array<double, 2>>& radius_and_height) {
  std::vector<Triangle> out;
  const auto at = [](const std::array<double, 2>& ring, int i) {
    const double angle = 2 * std::numbers::pi * (i % kAround) / kAround;
    return Vec3{ring[0] * std::cos(angle), ring[0] * std::sin(angle), ring[1]};
  };
  for (std::size_t ring = 0; ring + 1 < radius_and_height.size(); ++ring) {
    const auto& low = radius_and_height[ring];
    const auto& high = radius_and_height[ring + 1];
    for (int i = 0; i < kAround; ++i) {
      if (low[0] > 0) out.push_back({at(low, i), at(low, i + 1), at(high, i)});
      if (high[0] > 0) out.push_back({at(low, i + 1), at(high, i + 1), at(high, i)});
    }
  }
  return out;
}

std::vector<Triangle> cylinder(double radius, double length) {
  return turned({{0, -length / 2}, {radius, -length / 2}, {radius, length / 2}, {0, length / 2}});
}

std::vector<Triangle> sphere(double radius) {
  std::vector<std::array<double, 2>> rings;
  for (int i = 0; i <= kAround / 2; ++i) {
    const double angle = std::numbers::pi * i / (kAround / 2);
    const bool pole = i == 0 || i == kAround / 2;
    rings.push_back({pole ? 0 : radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return turned(rings);
}

}  // namespace

std::vector<Triangle> mesh(const world::Shape& shape) {
  switch (shape.kind) {
    case world::Shape::Kind::box:
      return box(shape.size);
    case world::Shape::Kind::cylinder:
      return cylinder(shape.size[0], shape.size[1]);
    case world::Shape::Kind::sphere:
      break;
  }
  return sphere(shape.size[0]);
}

}  // namespace race::camera
