#include "services/recognition/recognize.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "services/recognition/cloud.h"
#include "services/recognition/identify_internal.h"
#include "services/recognition/pixels.h"

namespace race::recognition {
namespace {

constexpr double kFarthest = 2.0;  // m: beyond, depth is too coarse for parts of a few centimetres
constexpr float kPlaneLeaf = 0.01F, kPartLeaf = 0.003F;  // m
constexpr double kPlaneTolerance = 0.008;                // m
constexpr double kPlaneShare = 0.25;                     // of what is seen
constexpr double kAbovePlane = 0.006;                    // m
constexpr double kGap = 0.012;                           // m between two parts of one colour
constexpr int kLeastPoints = 25;
constexpr double kLeastInliers = 0.9, kLeastCovered = 0.8;
constexpr double kDeepest = 0.008;  // m below the plane

struct Cluster {
  std::uint8_t colour = 0;
  Points points;
  Vector middle = Vector::Zero();
};

/// What is measured in a picture before any part is fitted.
struct Observation {
  const RgbdImage& image;
  std::vector<std::uint8_t> colours;  // of each pixel
  std::optional<Plane> plane;
  std::vector<Cluster> clusters;
  std::vector<SeenMarker> markers;  // on what can be a part with markers
};

Cloud to_cloud(const RgbdImage& image) {
  constexpr int kStride = 2;  // pixels: enough for a plane
  Cloud cloud;
  for (int v = 0; v < image.height; v += kStride) {
    for (int u = 0; u < image.width; u += kStride) {
      const double z = image.depth(u, v);
      if (z <= 0 || z > kFarthest) continue;
      const auto p = image.point(u, v);
      cloud.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    }
  }
  return cloud;
}

/// The points of each colour that do not belong to the plane.
std::vector<Cloud> coloured_clouds(const Observation& seen, std::size_t colours) {
  std::vector<Cloud> clouds(colours);
  for (int v = 0; v < seen.image.height; ++v) {
    for (int u = 0; u < seen.image.width; ++u) {
      const std::uint8_t colour = seen.colours[seen.image.index(u, v)];
      const double z = seen.image.depth(u, v);
      if (colour == kNoColour || z <= 0 || z > kFarthest) continue;
      const auto p = seen.image.point(u, v);
      if (seen.plane && seen.plane->height(p[0], p[1], p[2]) < kAbovePlane) continue;
      clouds[colour].push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    }
  }
  return clouds;
}

Cluster to_cluster(std::size_t colour, const Cloud& cloud) {
  Cluster cluster{static_cast<std::uint8_t>(colour), {}, Vector::Zero()};
  for (const auto& p : cloud) {
    cluster.points.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
    cluster.middle += cluster.points.back();
  }
  cluster.middle /= static_cast<double>(cloud.size());
  return cluster;
}

Observation observe(const RgbdImage& image, const std::vector<Colour>& palette) {
  Observation seen{image,
                   classify(image, palette),
                   find_plane(voxels(to_cloud(image), kPlaneLeaf), kPlaneTolerance, kPlaneShare),
                   {},
                   {}};
  const auto clouds = coloured_clouds(seen, palette.size());
  for (std::size_t colour = 0; colour < clouds.size(); ++colour)
    for (const Cloud& cluster : clusters(voxels(clouds[colour], kPartLeaf), kGap, kLeastPoints))
      seen.clusters.push_back(to_cluster(colour, cluster));
  return seen;
}

/// The region of the picture around a cluster, with room for sides that are hidden under a marker.
Region region_of(const Cluster& cluster, const RgbdImage& image) {
  double left = image.width, top = image.height, right = 0, bottom = 0;
  for (const Vector& p : cluster.points) {
    const double u = image.cx + image.fx * p.x() / p.z(), v = image.cy + image.fy * p.y() / p.z();
    left = std::min(left, u);
    right = std::max(right, u);
    top = std::min(top, v);
    bottom = std::max(bottom, v);
  }
  const double room = std::max(right - left, bottom - top) / 2;
  return {static_cast<int>(left - room), static_cast<int>(top - room), static_cast<int>(right + room) + 1,
          static_cast<int>(bottom + room) + 1};
}

/// Up, seen from the camera: away from the plane, or, without one, towards the camera.
Vector up_of(const Observation& seen) { return seen.plane ? to_eigen(seen.plane->normal) : Vector(-Vector::UnitZ()); }

/// First poses of a part of one colour: its bounding box laid into that of the cluster, in each way in which one of its
/// sides can be up.
std::vector<Transform> box_poses(const Model& model, const Cluster& cluster, const Vector& up) {
  // A frame f at the cluster: its z axis up, its x axis to the right of the picture.
  Rotation c_r_f;
  const Vector x = (Vector::UnitX() - up.x() * up).normalized();
  c_r_f << x, up.cross(x), up;
  std::vector<std::array<double, 2>> footprint;
  std::vector<double> heights;
  for (const Vector& c_p : cluster.points) {
    const Vector p = c_r_f.transpose() * c_p;
    footprint.push_back({p.x(), p.y()});
    heights.push_back(p.z());
  }
  // A few points are too high by noise: one in fifty is above the top.
  const auto top = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() - 1 - heights.size() / 50);
  std::nth_element(heights.begin(), top, heights.end());
  const Rectangle rectangle = smallest_rectangle(footprint);

  const Box box = bounding_box(model.part);
  std::vector<Transform> poses;
  const auto tried = [&](const Rotation& r) {
    return std::ranges::any_of(poses, [&](const Transform& each) {
      return model.symmetry.angle(from_eigen(each).orientation, from_eigen(Transform(r)).orientation) < 0.02;
    });
  };
  for (int side = 0; side < 6; ++side) {
    const Vector upwards = (side % 2 ? -1.0 : 1.0) * Vector::Unit(side / 2);
    const Rotation lie = Eigen::Quaterniond::FromTwoVectors(upwards, Vector::UnitZ()).toRotationMatrix();
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double yaw = rectangle.angle + quarter * M_PI / 2;
      const Rotation f_r_x = Eigen::AngleAxisd(yaw, Vector::UnitZ()).toRotationMatrix() * lie;
      if (tried(c_r_f * f_r_x)) continue;
      const double half_height = (f_r_x.cwiseAbs() * to_eigen(box.half)).z();
      Transform c_t_x = Transform::Identity();
      c_t_x.linear() = c_r_f * f_r_x;
      c_t_x.translation() =
          c_r_f * Vector(rectangle.x, rectangle.y, *top - half_height) - c_t_x.linear() * to_eigen(box.middle);
      poses.push_back(c_t_x);
    }
  }
  return poses;
}

struct Candidate {
  std::size_t part = 0;
  std::vector<std::size_t> clusters;
  Transform c_t_x = Transform::Identity();
  Fit fit;
};

std::vector<ColouredPoints> points_of(const Observation& seen, const std::vector<std::size_t>& clusters) {
  std::vector<ColouredPoints> all;
  for (const std::size_t i : clusters) all.push_back({seen.clusters[i].colour, seen.clusters[i].points});
  return all;
}

/// The better of what there is and what `start` leads to, if that is no other part by its markers.
void try_pose(const Model& model, const Observation& seen, const Transform& start, Candidate& best) {
  const auto points = points_of(seen, best.clusters);
  Transform c_t_x = refine(model, points, start);
  if (!model.part.markers.empty()) {
    const auto identified = identify(model, c_t_x, seen.markers, seen.image);
    if (!identified) return;
    c_t_x = *identified;
  }
  const Fit fit = assess(model, points, c_t_x, seen.image, seen.colours, seen.plane);
  if (fit.confidence() <= best.fit.confidence()) return;
  best.c_t_x = c_t_x;
  best.fit = fit;
}

/// The pose that brings the pieces to these middles, with the least squares (Kabsch); none if they are arranged
/// otherwise.
std::optional<Transform> arrange(const Part& part, const Points& middles) {
  constexpr double kApart = 0.015;  // m
  const auto n = static_cast<Eigen::Index>(middles.size());
  Eigen::Matrix3Xd model(3, n), picture(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    model.col(i) = to_eigen(part.pieces[static_cast<std::size_t>(i)].x_t_piece.position);
    picture.col(i) = middles[static_cast<std::size_t>(i)];
  }
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (std::abs((model.col(i) - model.col(j)).norm() - (picture.col(i) - picture.col(j)).norm()) > kApart) return {};
  Transform c_t_x = Transform::Identity();
  c_t_x.matrix() = Eigen::umeyama(model, picture, false);
  return c_t_x;
}

/// Where the middle of a piece is, of which the side towards the camera is seen.
Vector middle_of_piece(const Piece& piece, const Cluster& cluster) {
  const double radius = piece.kind == Piece::Kind::box ? piece.size[0] / 2 : piece.size[0];
  return cluster.middle + 2.0 / 3.0 * radius * cluster.middle.normalized();
}

/// All ways to give each piece a cluster of its colour that are arranged as the part is.
void try_arrangements(const Model& model, const Observation& seen, std::size_t part, Candidate partial, Points middles,
                      std::vector<Candidate>& out) {
  const std::size_t next = partial.clusters.size();
  if (next == model.part.pieces.size()) {
    const auto start = arrange(model.part, middles);
    if (!start) return;
    try_pose(model, seen, *start, partial);
    out.push_back(std::move(partial));
    return;
  }
  for (std::size_t i = 0; i < seen.clusters.size(); ++i) {
    if (seen.clusters[i].colour != model.colours[next]) continue;
    Candidate more = partial;
    more.clusters.push_back(i);
    Points with = middles;
    with.push_back(middle_of_piece(model.part.pieces[next], seen.clusters[i]));
    try_arrangements(model, seen, part, std::move(more), std::move(with), out);
  }
}

bool is_good(const Candidate& candidate) {
  return candidate.fit.inliers >= kLeastInliers && candidate.fit.covered >= kLeastCovered &&
         candidate.fit.sunk <= kDeepest;
}

}  // namespace

struct Recognizer::Knowledge {
  std::vector<std::string> labels;
  std::vector<Colour> palette;
  std::vector<Model> models;

  std::uint8_t index_of(const Colour& colour) {
    const auto found = std::ranges::find(palette, colour);
    if (found == palette.end()) palette.push_back(colour);
    return static_cast<std::uint8_t>(std::ranges::find(palette, colour) - palette.begin());
  }

  bool sought(std::size_t part, const std::vector<std::string>& among) const {
    return std::ranges::find(among, labels[part]) != among.end();
  }

  /// The markers on what has a colour of a part that is sought by its markers.
  std::vector<SeenMarker> markers(const Observation& seen, const std::vector<std::string>& among) const {
    std::vector<SeenMarker> out;
    for (const Cluster& cluster : seen.clusters) {
      bool asked = false;
      for (std::size_t part = 0; part < models.size(); ++part)
        asked = asked || (sought(part, among) && !models[part].part.markers.empty() &&
                          std::ranges::find(models[part].colours, cluster.colour) != models[part].colours.end());
      if (asked) std::ranges::copy(find_markers(seen.image, region_of(cluster, seen.image)), std::back_inserter(out));
    }
    return out;
  }

  std::vector<Candidate> candidates(std::size_t part, const Observation& seen) const {
    const Model& model = models[part];
    std::vector<Candidate> out;
    const bool one_colour = std::ranges::all_of(model.colours, [&](auto c) { return c == model.colours.front(); });
    if (!one_colour) {
      try_arrangements(model, seen, part, {part, {}, Transform::Identity(), {}}, {}, out);
      return out;
    }
    for (std::size_t i = 0; i < seen.clusters.size(); ++i) {
      if (seen.clusters[i].colour != model.colours.front()) continue;
      Candidate best{part, {i}, Transform::Identity(), {}};
      for (const Transform& start : box_poses(model, seen.clusters[i], up_of(seen))) try_pose(model, seen, start, best);
      out.push_back(std::move(best));
    }
    return out;
  }
};

Recognizer::Recognizer(std::vector<Part> parts) : knowledge_(std::make_unique<Knowledge>()) {
  for (Part& part : parts) {
    Symmetry symmetry(part.symmetry);
    Model model{std::move(part), {}, std::move(symmetry)};
    for (const Piece& piece : model.part.pieces) model.colours.push_back(knowledge_->index_of(piece.colour));
    knowledge_->labels.push_back(model.part.label);
    knowledge_->models.push_back(std::move(model));
  }
}

Recognizer::~Recognizer() = default;

const std::vector<std::string>& Recognizer::labels() const { return knowledge_->labels; }

std::vector<Detection> Recognizer::recognize(const RgbdImage& image, const std::vector<std::string>& labels) const {
  Observation seen = observe(image, knowledge_->palette);
  seen.markers = knowledge_->markers(seen, labels);
  std::vector<Candidate> candidates;
  for (std::size_t part = 0; part < knowledge_->models.size(); ++part) {
    if (!knowledge_->sought(part, labels)) continue;
    std::ranges::copy_if(knowledge_->candidates(part, seen), std::back_inserter(candidates), is_good);
  }
  std::ranges::stable_sort(candidates, std::greater{}, [](const Candidate& c) { return c.fit.confidence(); });

  std::vector<Detection> detections;
  std::vector<bool> taken(seen.clusters.size(), false);
  const Vector up = up_of(seen);
  for (const Candidate& each : candidates) {
    if (std::ranges::any_of(each.clusters, [&](std::size_t i) { return taken[i]; })) continue;
    for (const std::size_t i : each.clusters) taken[i] = true;
    Pose c_t_x = from_eigen(each.c_t_x);
    const Model& model = knowledge_->models[each.part];
    if (model.part.markers.empty())
      c_t_x.orientation = model.symmetry.upright(c_t_x.orientation, {up.x(), up.y(), up.z()}, {1, 0, 0});
    detections.push_back({knowledge_->labels[each.part], c_t_x, each.fit.confidence()});
  }
  return detections;
}

}  // namespace race::recognition
