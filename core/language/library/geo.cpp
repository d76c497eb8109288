// The module geo: poses {"position": [x, y, z], "orientation": [qx, qy, qz, qw]}, metres and radians. A pose a_t_b is
// the pose of b, seen from a; compose(a_t_b, b_t_c) is a_t_c. Quaternions are normalised when they are read.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "core/language/library/library_internal.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language::library {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Pose {
  Vector3d position = Vector3d::Zero();
  Quaterniond orientation = Quaterniond::Identity();
};

// `count` numbers of a list into `out`; a type fault if they are something else.
bool numbers(Context& context, const Value& v, std::size_t count, double* out, std::string_view what) {
  bool good = v.is_list() && v.as_list().size() == count;
  for (std::size_t i = 0; good && i < count; ++i) {
    good = v.as_list()[i].is_numeric();
    if (good) out[i] = v.as_list()[i].to_double();
  }
  if (!good)
    context.fail(FaultKind::type, std::string(what) + " must be a list of " + std::to_string(count) + " numbers");
  return good;
}

bool read(Context& context, const Value& v, Vector3d& point, std::string_view what) {
  return numbers(context, v, 3, point.data(), what);
}

bool read(Context& context, const Value& v, Quaterniond& q, std::string_view what) {
  double c[4];
  if (!numbers(context, v, 4, c, what)) return false;
  q = Quaterniond(c[3], c[0], c[1], c[2]);
  const double norm = q.norm();
  if (!(norm > 0) || !std::isfinite(norm)) {
    context.fail(FaultKind::value, "a quaternion must be finite and not zero");
    return false;
  }
  q.coeffs() /= norm;
  return true;
}

bool read(Context& context, const Value& v, Pose& pose) {
  const Value* position = v.find("position");
  const Value* orientation = v.find("orientation");
  if (position == nullptr || orientation == nullptr) {
    context.fail(FaultKind::type, "a pose is a dict with position and orientation");
    return false;
  }
  return read(context, *position, pose.position, "position") &&
         read(context, *orientation, pose.orientation, "orientation");
}

bool read(Context& context, const Value& v, double& number) {
  if (v.is_numeric()) {
    number = v.to_double();
  } else {
    context.fail(FaultKind::type, "must be real number, not " + std::string(type_name(v)));
  }
  return v.is_numeric();
}

Value write(const Vector3d& p) { return Value(List{Value(p.x()), Value(p.y()), Value(p.z())}); }
Value write(const Quaterniond& q) { return Value(List{Value(q.x()), Value(q.y()), Value(q.z()), Value(q.w())}); }
Value write(const Pose& pose) {
  return Value(Dict{{"position", write(pose.position)}, {"orientation", write(pose.orientation)}});
}

Pose composed(const Pose& a, const Pose& b) {
  return {a.position + a.orientation * b.position, (a.orientation * b.orientation).normalized()};
}

// A position is that of a pose, or a list of three numbers.
bool read_position(Context& context, const Value& v, Vector3d& point) {
  Pose pose;
  if (v.is_list()) return read(context, v, point, "a point");
  if (!read(context, v, pose)) return false;
  point = pose.position;
  return true;
}

}  // namespace

/// pose(position, orientation): the orientation normalised.
Value geo_pose(Context& context, Arguments arguments) {
  Pose pose;
  const bool good = read(context, arguments[0], pose.position, "position") &&
                    read(context, arguments[1], pose.orientation, "orientation");
  return good ? write(pose) : Value::unknown();
}

Value geo_identity(Context&, Arguments) { return write(Pose{}); }

/// compose(a_t_b, b_t_c): a_t_c.
Value geo_compose(Context& context, Arguments arguments) {
  Pose a;
  Pose b;
  return read(context, arguments[0], a) && read(context, arguments[1], b) ? write(composed(a, b)) : Value::unknown();
}

/// inverse(a_t_b): b_t_a.
Value geo_inverse(Context& context, Arguments arguments) {
  Pose a;
  if (!read(context, arguments[0], a)) return Value::unknown();
  const Quaterniond back = a.orientation.conjugate();
  return write(Pose{back * -a.position, back});
}

/// transform(a_t_b, point seen from b): the point seen from a.
Value geo_transform(Context& context, Arguments arguments) {
  Pose a;
  Vector3d point;
  if (!read(context, arguments[0], a) || !read(context, arguments[1], point, "a point")) return Value::unknown();
  return write(Vector3d(a.position + a.orientation * point));
}

/// distance(a, b): metres between two poses or points.
Value geo_distance(Context& context, Arguments arguments) {
  Vector3d a;
  Vector3d b;
  const bool good = read_position(context, arguments[0], a) && read_position(context, arguments[1], b);
  return good ? Value((a - b).norm()) : Value::unknown();
}

/// angle(a, b): radians, 0 to pi, of the rotation from one orientation to the other.
Value geo_angle(Context& context, Arguments arguments) {
  Pose a;
  Pose b;
  if (!read(context, arguments[0], a) || !read(context, arguments[1], b)) return Value::unknown();
  return Value(a.orientation.angularDistance(b.orientation));
}

/// rpy(r, p, y): the quaternion of a rotation by r about x, then p about y, then y about z, of the fixed axes.
Value geo_rpy(Context& context, Arguments arguments) {
  double angles[3];
  for (std::size_t i = 0; i < 3; ++i)
    if (!read(context, arguments[i], angles[i])) return Value::unknown();
  return write(
      Quaterniond(Eigen::AngleAxisd(angles[2], Vector3d::UnitZ()) * Eigen::AngleAxisd(angles[1], Vector3d::UnitY()) *
                  Eigen::AngleAxisd(angles[0], Vector3d::UnitX())));
}

/// to_rpy(pose): [r, p, y] with p in -pi/2 to pi/2; at its ends r is 0.
Value geo_to_rpy(Context& context, Arguments arguments) {
  Pose pose;
  if (!read(context, arguments[0], pose)) return Value::unknown();
  const Eigen::Matrix3d m = pose.orientation.toRotationMatrix();
  const double across = std::hypot(m(0, 0), m(1, 0));
  const double pitch = std::atan2(-m(2, 0), across);
  constexpr double kUpright = 1e-9;
  if (across < kUpright) return write(Vector3d(0.0, pitch, std::atan2(-m(0, 1), m(1, 1))));
  return write(Vector3d(std::atan2(m(2, 1), m(2, 2)), pitch, std::atan2(m(1, 0), m(0, 0))));
}

/// interpolate(a, b, s): a at s = 0, b at s = 1; positions on a line, orientations on the shorter arc.
Value geo_interpolate(Context& context, Arguments arguments) {
  Pose a;
  Pose b;
  double s = 0;
  if (!read(context, arguments[0], a) || !read(context, arguments[1], b) || !read(context, arguments[2], s))
    return Value::unknown();
  if (!std::isfinite(s)) return context.fail(FaultKind::value, "s must be finite");
  return write(Pose{a.position + s * (b.position - a.position), a.orientation.slerp(s, b.orientation).normalized()});
}

/// mean(poses): the mean position, and the orientation that is nearest to all in the sense of least squares (the
/// greatest eigenvector of the sum of q qᵀ), with qw >= 0.
Value geo_mean(Context& context, Arguments arguments) {
  const Value items = elements(context, arguments[0]);
  if (context.failed) return items;
  const List& poses = items.as_list();
  if (poses.empty()) return context.fail(FaultKind::value, "the mean of no poses");
  Vector3d sum = Vector3d::Zero();
  Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
  if (!context.charge(work::made(poses.size()))) return Value::unknown();
  for (const Value& v : poses) {
    Pose pose;
    if (!read(context, v, pose)) return Value::unknown();
    sum += pose.position;
    products += pose.orientation.coeffs() * pose.orientation.coeffs().transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(products);
  Quaterniond q;
  q.coeffs() = solver.eigenvectors().col(3);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return write(Pose{sum / static_cast<double>(poses.size()), q.normalized()});
}

/// offset(pose, x, y, z): the pose moved along its own axes, in metres.
Value geo_offset(Context& context, Arguments arguments) {
  Pose pose;
  Pose by;
  if (!read(context, arguments[0], pose)) return Value::unknown();
  for (int i = 0; i < 3; ++i)
    if (!read(context, arguments[static_cast<std::size_t>(i) + 1], by.position[i])) return Value::unknown();
  return write(composed(pose, by));
}

}  // namespace race::language::library
