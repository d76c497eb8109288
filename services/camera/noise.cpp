#include "services/camera/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace race::camera {
namespace {

constexpr double kStepAt1m = 2.85e-3;  // m of depth at 1 m for one step of disparity
constexpr double kEdge = 0.02;         // relative jump in depth that makes an edge

/// A number that depends on seed and counter alone (splitmix64), so that pixels need no order.
std::uint64_t hashed(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t x = seed + (counter + 1) * 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31);
}

double uniform(std::uint64_t bits) { return static_cast<double>(bits & 0xFFFFU) / 65536.0; }

/// Nearly normal with deviation 1: the sum of the four 16-bit parts of `bits`, each uniform with variance 1/12.
double normal(std::uint64_t bits) {
  const double sum = uniform(bits) + uniform(bits >> 16) + uniform(bits >> 32) + uniform(bits >> 48);
  return (sum - 2.0) * std::numbers::sqrt3;
}

bool beside_edge(const Picture& picture, int u, int v) {
  const auto at = [&](int x, int y) {
    return static_cast<double>(picture.depth[static_cast<std::size_t>(y * picture.width + x)]);
  };
  const double here = at(u, v);
  const auto jump = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return false;
    return std::abs(at(x, y) - here) > kEdge * here;
  };
  return jump(u - 1, v) || jump(u + 1, v) || jump(u, v - 1) || jump(u, v + 1);
}

/// Of a surface with this cosine: 0 if it is measured for certain, 1 if never.
double share_lost(double facing) {
  constexpr double kNever = 85, kAlways = 70;  // degrees
  const double angle = std::acos(std::clamp(facing, 0.0, 1.0)) * 180 / std::numbers::pi;
  return std::clamp((angle - kAlways) / (kNever - kAlways), 0.0, 1.0);
}

std::uint16_t depth_mm(double z, double noise) {
  const double steps = std::floor(1 / (kStepAt1m * z) + noise + 0.5);
  const double measured = 1 / (kStepAt1m * steps);
  if (steps < 1 || measured < kKinectNearest || measured > kKinectFarthest) return 0;
  return static_cast<std::uint16_t>(measured * 1000 + 0.5);
}

Rgb noisy(Rgb colour, std::uint64_t bits) {
  // -3..3, each as likely: a deviation of 2.
  const auto channel = [&](std::uint8_t c, int shift) {
    const int noise = static_cast<int>((bits >> shift & 0xFFFFU) * 7 >> 16) - 3;
    return static_cast<std::uint8_t>(std::clamp(c + noise, 0, 255));
  };
  return {channel(colour.r, 0), channel(colour.g, 16), channel(colour.b, 32)};
}

}  // namespace

Measurement measure(const Picture& picture, std::uint64_t seed) {
  const std::size_t pixels = picture.depth.size();
  Measurement out{picture.width, picture.height, std::vector<std::uint16_t>(pixels), std::vector<Rgb>(pixels)};
  std::size_t pixel = 0;
  for (int v = 0; v < picture.height; ++v) {
    for (int u = 0; u < picture.width; ++u, ++pixel) {
      const std::uint64_t luck = hashed(seed, 3 * pixel);
      out.colour[pixel] = noisy(picture.colour[pixel], luck);
      const auto z = static_cast<double>(picture.depth[pixel]);
      if (z <= 0) continue;
      const double facing = static_cast<double>(picture.facing[pixel]);
      const double fate = uniform(hashed(seed, 3 * pixel + 1));
      // Only surfaces beyond 60 degrees can be lost: the cosine spares the angle for the others.
      if (facing < 0.5 && fate < share_lost(facing)) continue;
      if (fate < 0.5 && beside_edge(picture, u, v)) continue;
      out.depth_mm[pixel] = depth_mm(z, 0.5 * normal(hashed(seed, 3 * pixel + 2)));
    }
  }
  return out;
}

}  // namespace race::camera
