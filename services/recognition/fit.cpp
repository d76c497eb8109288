#include <algorithm>
#include <cmath>

#include "services/recognition/fit_internal.h"
#include "services/recognition/identify_internal.h"
#include "services/recognition/surface_internal.h"

namespace race::recognition {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kSteps = 30;
constexpr double kFirstReach = 0.02, kLastReach = 0.006;  // m; points farther from the surface do not pull

/// From the nearest surface of a piece of this colour; the point and the gradient are in the part's frame.
Distance nearest(const Model& model, std::uint8_t colour, const Vector& point) {
  Distance best{1e9, Vector::UnitZ()};
  for (std::size_t i = 0; i < model.part.pieces.size(); ++i) {
    if (model.colours[i] != colour) continue;
    const Piece& piece = model.part.pieces[i];
    const Transform x_t_piece = to_eigen(piece.x_t_piece);
    const Distance here = distance(piece, x_t_piece.inverse() * point);
    if (std::abs(here.value) < std::abs(best.value)) best = {here.value, x_t_piece.linear() * here.gradient};
  }
  return best;
}

/// One step: the small turn and shift, in the part's frame, that bring the points nearest to the surface.
Vector6 step(const Model& model, const std::vector<ColouredPoints>& seen, const Transform& x_t_c, double reach) {
  Matrix6 a = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  for (const ColouredPoints& group : seen) {
    for (const Vector& c_p : group.points) {
      const Vector p = x_t_c * c_p;
      const Distance d = nearest(model, group.colour, p);
      if (std::abs(d.value) > reach) continue;
      Vector6 row;
      row << p.cross(d.gradient), d.gradient;
      a += row * row.transpose();
      b -= d.value * row;
    }
  }
  // What the points do not fix (the turn of a cylinder) stays as it is.
  const double damping = 1e-6 * a.trace() / 6 + 1e-12;
  return (a + damping * Matrix6::Identity()).ldlt().solve(b);
}

}  // namespace

Transform refine(const Model& model, const std::vector<ColouredPoints>& seen, Transform c_t_x) {
  for (int i = 0; i < kSteps; ++i) {
    const double share = std::min(1.0, static_cast<double>(i) / (kSteps / 2));
    const Vector6 change = step(model, seen, c_t_x.inverse(), kFirstReach + share * (kLastReach - kFirstReach));
    const double angle = change.head<3>().norm();
    Transform points_move = Transform::Identity();
    if (angle > 1e-12) points_move.linear() = Eigen::AngleAxisd(angle, change.head<3>() / angle).toRotationMatrix();
    points_move.translation() = change.tail<3>();
    c_t_x = c_t_x * points_move.inverse();
    if (share == 1 && angle < 1e-5 && change.tail<3>().norm() < 1e-6) break;
  }
  return c_t_x;
}

Fit assess(const Model& model, const std::vector<ColouredPoints>& seen, const Transform& c_t_x, const RgbdImage& image,
           const std::vector<std::uint8_t>& colours, const std::optional<Plane>& plane) {
  Fit fit;
  double points = 0, on_surface = 0, squares = 0;
  const Transform x_t_c = c_t_x.inverse();
  for (const ColouredPoints& group : seen) {
    for (const Vector& c_p : group.points) {
      ++points;
      const double off = nearest(model, group.colour, x_t_c * c_p).value;
      if (std::abs(off) > 3 * deviation(c_p.z())) continue;
      ++on_surface;
      squares += off * off;
    }
  }
  if (on_surface > 0) fit.rms = std::sqrt(squares / on_surface);
  fit.inliers = points > 0 ? on_surface / points : 0;

  constexpr double kSpacing = 0.004;     // m
  constexpr double kLeastFacing = 0.35;  // surfaces more slanted than 70 degrees may not be measured
  double supported = 0, refuted = 0;
  for (std::size_t i = 0; i < model.part.pieces.size(); ++i) {
    for (const Sample& sample : samples(model.part.pieces[i], kSpacing)) {
      const Vector p = c_t_x * sample.point;
      if (plane) fit.sunk = std::max(fit.sunk, -plane->height(p.x(), p.y(), p.z()));
      if (p.z() <= 0 || -(c_t_x.linear() * sample.normal).dot(p.normalized()) < kLeastFacing) continue;
      const int u = static_cast<int>(std::lround(image.cx + image.fx * p.x() / p.z()));
      const int v = static_cast<int>(std::lround(image.cy + image.fy * p.y() / p.z()));
      const double measured = image.depth(u, v);
      const double tolerance = 3 * deviation(p.z()) + kSpacing;
      if (measured == 0 || measured < p.z() - tolerance) continue;  // nothing known, or hidden behind something
      const bool there = measured < p.z() + tolerance &&
                         (colours[image.index(u, v)] == model.colours[i] || is_printed(model.part, sample.point));
      ++(there ? supported : refuted);
    }
  }
  if (supported > 0) fit.covered = supported / (supported + refuted);
  return fit;
}

}  // namespace race::recognition
