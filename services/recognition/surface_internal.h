// Surfaces of parts: how far a point is from one, and samples of it.
#pragma once

#include "services/recognition/geometry_internal.h"

namespace race::recognition {

/// The signed distance of a point from a surface (negative inside) and the direction in which it grows.
struct Distance {
  double value = 0;
  Vector gradient = Vector::UnitZ();
};

/// Of `point`, in the piece's own frame.
Distance distance(const Piece& piece, const Vector& point);

struct Sample {
  Vector point, normal;
};

/// Points on the surface of `piece`, in the part's frame, about `spacing` [m] apart.
std::vector<Sample> samples(const Piece& piece, double spacing);

}  // namespace race::recognition
