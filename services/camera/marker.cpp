#include "services/camera/marker.h"

#include "services/camera/vector_internal.h"
#include "services/marker.h"

namespace race::camera {
namespace {

constexpr Rgb kBlack{20, 20, 20}, kWhite{240, 240, 240};  // as printers make them
constexpr double kHigh = 1e-4;                            // m, of what is printed above what is below it

/// A box around (x, y) of the marker's plane that stands out of it by `high`.
Item label(const world::Pose& c_t_marker, double x, double y, double width, double height, double high, Rgb colour) {
  return {
      {world::Shape::Kind::box, {width, height, high}}, compose(c_t_marker, {{x, y, high / 2}, {0, 0, 0, 1}}), colour};
}

}  // namespace

void add_marker(const world::Marker& marker, const world::Pose& c_t_body, std::vector<Item>& items) {
  const world::Pose c_t_marker = compose(c_t_body, marker.body_t_marker);
  items.push_back(label(c_t_marker, 0, 0, marker.side, marker.side, kHigh, kBlack));
  const double cell = marker.side / services::kMarkerCells;
  constexpr int kInner = services::kMarkerInner;
  for (int row = 0; row < kInner; ++row) {
    for (int first = 0, last = 0; first < kInner; first = last + 1) {
      // Neighbours in a row are one, so that no seam between them can show.
      last = first;
      if (!services::is_white(marker.id, row, first)) continue;
      while (last + 1 < kInner && services::is_white(marker.id, row, last + 1)) ++last;
      const double x = (first + last + 1 - kInner) * cell / 2, y = ((kInner - 1) / 2.0 - row) * cell;
      items.push_back(label(c_t_marker, x, y, (last + 1 - first) * cell, cell, 2 * kHigh, kWhite));
    }
  }
}

}  // namespace race::camera
