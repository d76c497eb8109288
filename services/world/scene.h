// Scene: what stands in a cell and where the robot is mounted, read from a scene file (deploy/demo/scene.json is one).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/world/pose.h"
#include "services/world/robot_model.h"

namespace race::world {

/// A printed marker (services/marker.h) on a body: it is seen, and touches nothing.
struct Marker {
  int id = 0;
  double side = 0;  // m, of the black square
  /// Its middle; x to the right and y up of what is printed, z out of it towards who reads it.
  Pose body_t_marker;
};

/// A rigid body. The coefficient of Coulomb friction of a pair is the product of its two `friction` values.
struct Body {
  std::string name;
  Shape shape;
  Pose o_t_body;
  double mass = 0;  // kg; 0: immovable
  double friction = 0.5;
  std::string colour;  // "#rrggbb", for viewers
  std::vector<Marker> markers{};
};

struct Mounting {
  std::string urdf;               // path of the URDF, relative to the scene file's folder
  Pose o_t_base;                  // root link of the URDF seen from the world's origin o
  std::array<double, 7> q{};      // rad, posture at the start
  double width = 0;               // m, opening of the gripper at the start
  double finger_friction = 1.0;   // of the finger pads
  double surface_friction = 0.5;  // of all other links
};

/// Where a depth camera stands. Its frame c: z along the view, x to the right and y down in the picture.
struct CameraMount {
  Pose o_t_c;
  double rate_hz = 30;  // pictures in a second of world time
};

struct Scene {
  std::string name;
  Mounting robot;
  std::vector<Body> bodies;
  std::optional<CameraMount> camera;
};

/// Reads a scene document. Errors name the field (path such as `bodies[2].mass`): `missing`, `type`, `unknown_field`,
/// `out_of_range`, `duplicate`, `version`, `unknown_name` (a dictionary of markers).
Expected<Scene> read_scene(const Value& document);

/// Reads a scene file; the URDF's path becomes one that can be opened. Errors: `io`, those of parse_json and
/// read_scene.
Expected<Scene> load_scene(const std::string& path);

}  // namespace race::world
