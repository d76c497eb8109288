#include <algorithm>
#include <limits>

#include "services/recognition/identify_internal.h"

namespace race::recognition {
namespace {

using Corners = std::array<ImagePoint, 4>;

double apart(const ImagePoint& a, const ImagePoint& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

ImagePoint middle(const Corners& corners) {
  ImagePoint sum{};
  for (const ImagePoint& corner : corners) sum = {sum[0] + corner[0] / 4, sum[1] + corner[1] / 4};
  return sum;
}

/// The mean distance of corners that belong together.
double apart(const Corners& a, const Corners& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += apart(a[i], b[i]) / 4;
  return sum;
}

double mean_edge(const Corners& corners) { return apart(corners, {corners[1], corners[2], corners[3], corners[0]}); }

/// Where a marker is in the picture; none if it faces away.
std::optional<Corners> drawn(const Marker& marker, const Transform& c_t_x, const RgbdImage& image) {
  const Transform c_t_marker = c_t_x * to_eigen(marker.x_t_marker);
  if (c_t_marker.linear().col(2).dot(c_t_marker.translation()) >= 0) return std::nullopt;
  const double h = marker.side / 2;
  const Vector corners[] = {{-h, h, 0}, {h, h, 0}, {h, -h, 0}, {-h, -h, 0}};
  Corners out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vector p = c_t_marker * corners[i];
    if (p.z() <= 0) return std::nullopt;
    out[i] = {image.cx + image.fx * p.x() / p.z(), image.cy + image.fy * p.y() / p.z()};
  }
  return out;
}

/// How a pose agrees with the markers that were seen.
struct Agreement {
  int markers = 0;     // of the part that are seen where they should be
  double apart = 0;    // pixels, between the corners of these, in all
  bool wrong = false;  // another marker, or one turned otherwise, is where one should be
};

Agreement agreement(const Part& part, const Transform& c_t_x, const std::vector<SeenMarker>& seen,
                    const RgbdImage& image) {
  constexpr double kApart = 0.25;  // of an edge: a quarter turn moves the corners by a whole one
  Agreement out;
  for (const Marker& marker : part.markers) {
    const auto expected = drawn(marker, c_t_x, image);
    if (!expected) continue;
    const double edge = mean_edge(*expected);
    for (const SeenMarker& each : seen) {
      if (apart(middle(each.corners), middle(*expected)) > edge / 2) continue;
      const double corners = apart(each.corners, *expected);
      if (each.id != marker.id || corners > kApart * edge) {
        out.wrong = true;
      } else {
        ++out.markers;
        out.apart += corners;
      }
    }
  }
  return out;
}

}  // namespace

std::optional<Transform> identify(const Model& model, const Transform& c_t_x, const std::vector<SeenMarker>& seen,
                                  const RgbdImage& image) {
  std::optional<Transform> best;
  Agreement of_best;
  for (const Quaternion& turn : model.symmetry.turns()) {
    const Transform turned = c_t_x * Transform(rotation(turn));
    const Agreement here = agreement(model.part, turned, seen, image);
    if (here.wrong || here.markers == 0) continue;
    if (best && (here.markers < of_best.markers || (here.markers == of_best.markers && here.apart >= of_best.apart)))
      continue;
    best = turned;
    of_best = here;
  }
  return best;
}

bool is_printed(const Part& part, const Vector& point) {
  constexpr double kBeside = 0.002;  // m: a pixel at 1 m
  return std::ranges::any_of(part.markers, [&](const Marker& marker) {
    const Vector p = to_eigen(marker.x_t_marker).inverse() * point;
    return p.cwiseAbs().head<2>().maxCoeff() <= marker.side / 2 + kBeside && std::abs(p.z()) <= kBeside;
  });
}

}  // namespace race::recognition
