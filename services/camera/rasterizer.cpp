// Scan conversion with a depth buffer: over the picture of a plane, 1/z is linear in u and v, so each triangle is drawn
// from its plane's equation, row by row between its edges; surfaces that look away are left out.
#include "services/camera/rasterizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "services/camera/mesh.h"
#include "services/camera/vector_internal.h"

namespace race::camera {
namespace {

/// A plane that is seen: its normal towards the camera and its colour as lit.
struct Surface {
  Vec3 normal;
  double offset;  // normal . point, negative
  Rgb colour;
};

struct Canvas {
  const Intrinsics& pinhole;
  std::vector<float> inverse_depth;  // 0: nothing
  std::vector<std::int32_t> surface;
  std::vector<Surface> surfaces;
};

struct Point2 {
  double u, v;
};

Rgb lit(Rgb colour, const Vec3& normal) {
  // One lamp beside the camera; the rest of the room shines on everything.
  static const Vec3 kLamp = [] {
    const Vec3 to_lamp{-0.35, -0.55, -0.76};
    return (1 / norm(to_lamp)) * to_lamp;
  }();
  const double light = 0.45 + 0.55 * std::max(0.0, dot(normal, kLamp));
  const auto shade = [&](std::uint8_t c) { return static_cast<std::uint8_t>(std::lround(c * light)); };
  return {shade(colour.r), shade(colour.g), shade(colour.b)};
}

/// The part of a triangle beyond the near plane: none, three or four corners.
std::vector<Vec3> clip(const std::array<Vec3, 3>& corners) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % 3];
    const bool a_seen = a[2] >= kNearPlane, b_seen = b[2] >= kNearPlane;
    if (a_seen) out.push_back(a);
    if (a_seen != b_seen) out.push_back(a + ((kNearPlane - a[2]) / (b[2] - a[2])) * (b - a));
  }
  return out;
}

/// The pixels of row `v` that lie in the convex polygon: first and last, empty if first > last.
std::array<int, 2> span(const std::vector<Point2>& polygon, int v, int width) {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Point2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (a.v > b.v) std::swap(a, b);  // so that two neighbours compute the same edge
    if (v < a.v || v > b.v || a.v == b.v) continue;
    const double u = a.u + (v - a.v) / (b.v - a.v) * (b.u - a.u);
    left = std::min(left, u);
    right = std::max(right, u);
  }
  if (!(left <= right)) return {1, 0};
  return {static_cast<int>(std::ceil(std::clamp(left, 0.0, static_cast<double>(width)))),
          static_cast<int>(std::floor(std::clamp(right, -1.0, width - 1.0)))};
}

void draw(Canvas& canvas, const std::array<Vec3, 3>& corners, Rgb colour) {
  Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = norm(normal);
  if (length == 0) return;
  normal = (1 / length) * normal;
  const double offset = dot(normal, corners[0]);
  if (offset >= 0) return;  // faces away
  const std::vector<Vec3> seen = clip(corners);
  if (seen.empty()) return;

  const Intrinsics& k = canvas.pinhole;
  std::vector<Point2> polygon;
  double top = std::numeric_limits<double>::infinity(), bottom = -top;
  for (const Vec3& p : seen) {
    polygon.push_back({k.cx + k.fx * p[0] / p[2], k.cy + k.fy * p[1] / p[2]});
    top = std::min(top, polygon.back().v);
    bottom = std::max(bottom, polygon.back().v);
  }
  const int first = static_cast<int>(std::ceil(std::clamp(top, 0.0, static_cast<double>(k.height))));
  const int last = static_cast<int>(std::floor(std::clamp(bottom, -1.0, k.height - 1.0)));
  if (first > last) return;

  const auto id = static_cast<std::int32_t>(canvas.surfaces.size());
  canvas.surfaces.push_back({normal, offset, lit(colour, normal)});
  // normal . (z * ray) = offset, so 1/z = normal . ray / offset
  const double per_u = normal[0] / k.fx / offset, per_v = normal[1] / k.fy / offset;
  const double at_origin = normal[2] / offset - per_u * k.cx - per_v * k.cy;
  for (int v = first; v <= last; ++v) {
    const auto [from, to] = span(polygon, v, k.width);
    const double row = at_origin + per_v * v;
    const std::size_t start = static_cast<std::size_t>(v) * static_cast<std::size_t>(k.width);
    for (int u = from; u <= to; ++u) {
      const auto inverse = static_cast<float>(row + per_u * u);
      const std::size_t pixel = start + static_cast<std::size_t>(u);
      if (inverse <= canvas.inverse_depth[pixel]) continue;
      canvas.inverse_depth[pixel] = inverse;
      canvas.surface[pixel] = id;
    }
  }
}

Picture finish(const Canvas& canvas) {
  const Intrinsics& k = canvas.pinhole;
  const std::size_t pixels = canvas.inverse_depth.size();
  Picture picture{k.width, k.height, std::vector<float>(pixels), std::vector<float>(pixels), std::vector<Rgb>(pixels)};
  std::size_t pixel = 0;
  for (int v = 0; v < k.height; ++v) {
    const double y = (v - k.cy) / k.fy;
    for (int u = 0; u < k.width; ++u, ++pixel) {
      if (canvas.inverse_depth[pixel] <= 0) continue;
      const Surface& surface = canvas.surfaces[static_cast<std::size_t>(canvas.surface[pixel])];
      const double x = (u - k.cx) / k.fx;
      const double z = 1.0 / static_cast<double>(canvas.inverse_depth[pixel]);
      picture.depth[pixel] = static_cast<float>(z);
      picture.facing[pixel] = static_cast<float>(-surface.offset / (z * std::sqrt(x * x + y * y + 1)));
      picture.colour[pixel] = surface.colour;
    }
  }
  return picture;
}

}  // namespace

Rgb parse_colour(const std::string& text) {
  const auto number = static_cast<unsigned>(std::stoul(text.substr(1), nullptr, 16));
  return {static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 8 & 0xFFU),
          static_cast<std::uint8_t>(number & 0xFFU)};
}

Picture rasterize(const std::vector<Item>& items, const Intrinsics& intrinsics) {
  const auto pixels = static_cast<std::size_t>(intrinsics.width) * static_cast<std::size_t>(intrinsics.height);
  Canvas canvas{intrinsics, std::vector<float>(pixels, 0.0F), std::vector<std::int32_t>(pixels), {}};
  for (const Item& item : items) {
    for (const Triangle& triangle : mesh(item.shape)) {
      draw(canvas,
           {transform(item.c_t_shape, triangle[0]), transform(item.c_t_shape, triangle[1]),
            transform(item.c_t_shape, triangle[2])},
           item.colour);
    }
  }
  return finish(canvas);
}

}  // namespace race::camera
