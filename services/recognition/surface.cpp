#include <algorithm>
#include <cmath>
#include <numbers>

#include "services/recognition/surface_internal.h"

namespace race::recognition {
namespace {

Distance box_distance(const Vector& half, const Vector& p) {
  const Vector beyond = p.cwiseAbs() - half;
  const Vector sign = p.unaryExpr([](double c) { return c < 0 ? -1.0 : 1.0; });
  if (beyond.maxCoeff() > 0) {
    const Vector outside = beyond.cwiseMax(0);
    const double length = outside.norm();
    return {length, outside.cwiseProduct(sign) / length};
  }
  Eigen::Index nearest = 0;
  const double value = beyond.maxCoeff(&nearest);
  return {value, sign[nearest] * Vector::Unit(nearest)};
}

Distance cylinder_distance(double radius, double half, const Vector& p) {
  const double around = std::hypot(p.x(), p.y());
  const Vector outwards = around > 1e-9 ? Vector(p.x() / around, p.y() / around, 0) : Vector::UnitX();
  const Vector up = p.z() < 0 ? Vector(-Vector::UnitZ()) : Vector(Vector::UnitZ());
  const double side = around - radius, end = std::abs(p.z()) - half;
  if (side > 0 && end > 0) {
    const double length = std::hypot(side, end);
    return {length, (side * outwards + end * up) / length};
  }
  return side > end ? Distance{side, outwards} : Distance{end, up};
}

Distance sphere_distance(double radius, const Vector& p) {
  const double length = p.norm();
  return {length - radius, length > 1e-9 ? Vector(p / length) : Vector::UnitZ()};
}

int steps(double length, double spacing) { return std::max(1, static_cast<int>(std::lround(length / spacing))); }

void sample_box(const Vector& half, double spacing, std::vector<Sample>& out) {
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const int along_a = steps(2 * half[a], spacing), along_b = steps(2 * half[b], spacing);
    for (const double side : {-1.0, 1.0}) {
      for (int i = 0; i < along_a; ++i) {
        for (int j = 0; j < along_b; ++j) {
          Vector point;
          point[axis] = side * half[axis];
          point[a] = half[a] * ((2.0 * i + 1) / along_a - 1);
          point[b] = half[b] * ((2.0 * j + 1) / along_b - 1);
          out.push_back({point, side * Vector::Unit(axis)});
        }
      }
    }
  }
}

/// A band or ring about z: points at `radius` and `z`, with the normal leaning by `slope` from outwards (0) to up.
void sample_ring(double radius, double z, double slope, double spacing, std::vector<Sample>& out) {
  const int around = steps(2 * std::numbers::pi * radius, spacing);
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / around;
    const Vector outwards(std::cos(angle), std::sin(angle), 0);
    out.push_back(
        {radius * outwards + z * Vector::UnitZ(), std::cos(slope) * outwards + std::sin(slope) * Vector::UnitZ()});
  }
}

void sample_cylinder(double radius, double half, double spacing, std::vector<Sample>& out) {
  const int up = steps(2 * half, spacing), inwards = steps(radius, spacing);
  for (int i = 0; i < up; ++i) sample_ring(radius, half * ((2.0 * i + 1) / up - 1), 0, spacing, out);
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < inwards; ++i)
      sample_ring(radius * (i + 0.5) / inwards, side * half, side * std::numbers::pi / 2, spacing, out);
}

void sample_sphere(double radius, double spacing, std::vector<Sample>& out) {
  const int rings = steps(std::numbers::pi * radius, spacing);
  for (int i = 0; i < rings; ++i) {
    const double slope = std::numbers::pi * ((i + 0.5) / rings - 0.5);
    sample_ring(radius * std::cos(slope), radius * std::sin(slope), slope, spacing, out);
  }
}

}  // namespace

Distance distance(const Piece& piece, const Vector& point) {
  switch (piece.kind) {
    case Piece::Kind::box:
      return box_distance(to_eigen(piece.size) / 2, point);
    case Piece::Kind::cylinder:
      return cylinder_distance(piece.size[0], piece.size[1] / 2, point);
    case Piece::Kind::sphere:
      break;
  }
  return sphere_distance(piece.size[0], point);
}

std::vector<Sample> samples(const Piece& piece, double spacing) {
  std::vector<Sample> out;
  switch (piece.kind) {
    case Piece::Kind::box:
      sample_box(to_eigen(piece.size) / 2, spacing, out);
      break;
    case Piece::Kind::cylinder:
      sample_cylinder(piece.size[0], piece.size[1] / 2, spacing, out);
      break;
    case Piece::Kind::sphere:
      sample_sphere(piece.size[0], spacing, out);
      break;
  }
  const Transform x_t_piece = to_eigen(piece.x_t_piece);
  for (Sample& sample : out) sample = {x_t_piece * sample.point, x_t_piece.linear() * sample.normal};
  return out;
}

}  // namespace race::recognition
