// Tables of the simulated robot: how long from contact to detection for five speeds, which force it puts on a clamped
// body per behavior. World time only; this is a simulation and says nothing about a real robot's safety.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>

#include "services/robot/control_unit.h"
#include "services/world/world.h"

namespace {

using namespace race;
using robot::Behavior;
using robot::Mode;
using robot::Reaction;
using robot::Signal;

constexpr double kFace = 0.30;          // m, y of the side of the body that the gripper meets
constexpr double kHalfGripper = 0.073;  // m, from the tool's axis to the gripper's side

/// A cell with the robot and what the gripper's side meets when the tool moves along +y.
struct Cell {
  std::unique_ptr<world::World> world;
  std::unique_ptr<robot::ControlUnit> unit;

  explicit Cell(bool column) {
    world::Scene scene = world::load_scene(RACE_SOURCE_DIR "/deploy/demo/scene.json").value();
    scene.bodies.clear();
    const world::RobotModel model = world::load_urdf(scene.robot.urdf).value();
    if (column) {
      const double x = world::World::create(scene, model).value()->pose("tcp").position[0];
      world::Body body;
      body.name = "column";
      body.shape = {world::Shape::Kind::box, {0.05, 0.05, 1.0}};
      body.o_t_body.position = {x, kFace + 0.025, 0.3};
      scene.bodies.push_back(body);
    }
    world = world::World::create(scene, model).value();
    auto arm = robot::ArmModel::create(world->model(), scene.robot.o_t_base);
    unit = std::make_unique<robot::ControlUnit>(std::move(*arm), robot::lwr_settings(), world->q());
  }

  void step() {
    world->step();
    world->set_torques(unit->control(world->q(), world->dq()));
  }
  double face() const { return world->pose("tcp").position[1] + kHalfGripper; }
};

/// At this speed of the tool [m/s]: ms from contact to the residual's threshold, and to the changed command.
void detection(double speed) {
  Cell cell(true);
  Behavior behavior = robot::usual_behavior(Mode::position);
  behavior.operational.speed = speed;
  // Contact at the path's middle, where it is fastest.
  const double way = 2 * (kFace - cell.face());
  cell.unit->move(
      {.target = robot::Offset{{0, way, 0}}, .kind = robot::MotionKind::linear, .speed = 1, .acceleration = 1},
      behavior);
  double contact = -1, passed = -1, reacted = -1;
  std::string severity = "-";
  for (int i = 0; i < 20000 && reacted < 0; ++i) {
    cell.step();
    double force = 0;
    for (const char* link : {"gripper", "finger_left", "finger_right"})
      force += cell.world->contact_force(link, "column");
    if (contact < 0 && force > 0) contact = cell.world->time();
    const auto state = cell.unit->state();
    for (std::size_t j = 0; j < robot::kJoints; ++j) {
      if (passed < 0 && std::abs(state.tau_ext[j]) > robot::lwr_settings().contact_thresholds[j])
        passed = cell.world->time();
    }
    for (const auto& incident : cell.unit->take_incidents()) {
      if (incident.signal != Signal::collision) continue;
      reacted = cell.world->time();
      severity = name(incident.contact.severity);
    }
  }
  std::printf("| %.2f | %.0f | %.0f | %s |\n", speed, (passed - contact) * 1000, (reacted - passed) * 1000,
              severity.c_str());
}

/// A body of `mass` on a spring against a wall: what a measuring device for ISO/TS 15066 is, one-dimensional along y.
struct Clamp {
  double stiffness;         // N/m
  double mass;              // kg
  double damping;           // Ns/m
  double y = 0, speed = 0;  // of the body's face, beyond kFace

  /// Force [N] on the robot's face at `face`, and the body's motion during 1 ms, in small steps.
  double press(double face) {
    constexpr double kSkin = 2e5;  // N/m of the contact itself
    constexpr double kSkinDamping = 200;
    constexpr int kParts = 50;
    double mean = 0;
    for (int part = 0; part < kParts; ++part) {
      const double depth = face - kFace - y;
      const double force = depth > 0 ? std::max(0.0, kSkin * depth - kSkinDamping * speed) : 0;
      speed += (force - stiffness * y - damping * speed) / mass * (0.001 / kParts);
      y += speed * (0.001 / kParts);
      mean += force / kParts;
    }
    return mean;
  }
};

struct Named {
  const char* name;
  Behavior behavior;
};

/// Peak of the spring's force, and what is left after 2 s, of a clamped body that the tool meets with `speed`.
void clamping(const Named& named, double speed, double stiffness) {
  Cell cell(false);
  Clamp clamp{stiffness, 0.6, 40.0};  // the hand of ISO/TS 15066: 75 N/mm, 0.6 kg
  Behavior behavior = named.behavior;
  behavior.operational.speed = speed;
  const double way = 2 * (kFace - cell.face());
  cell.unit->move(
      {.target = robot::Offset{{0, way, 0}}, .kind = robot::MotionKind::linear, .speed = 1, .acceleration = 1},
      behavior);
  double peak = 0, steady = 0;
  bool met = false;
  int after = 0;
  for (int i = 0; i < 30000 && after < 2000; ++i) {
    const double force = clamp.press(cell.face());
    const auto p = cell.world->pose("tcp").position;
    if (force > 0) cell.world->push("gripper", {0, -force, 0}, {p[0], p[1] + kHalfGripper, p[2]});
    cell.step();
    met = met || force > 0;
    after += met ? 1 : 0;
    peak = std::max(peak, clamp.stiffness * clamp.y);
    steady = clamp.stiffness * clamp.y;
  }
  std::printf("| %s | %.2f | %.0f | %.0f | %.0f |\n", named.name, speed, stiffness / 1000, peak, std::abs(steady));
}

Behavior reacting(Mode mode, std::vector<robot::Reflex> reflexes) {
  Behavior behavior = robot::usual_behavior(mode);
  behavior.reflexes = std::move(reflexes);
  return behavior;
}

}  // namespace

int main() {
  std::puts(
      "| speed, m/s | contact to threshold, ms | threshold to changed command, ms | severity |\n|---|---|---|---|");
  for (const double speed : {0.05, 0.1, 0.2, 0.35, 0.5}) detection(speed);

  const std::vector<Named> behaviors = {
      {"position, no reflex", reacting(Mode::position, {})},
      {"position, stop", robot::usual_behavior(Mode::position)},
      {"position, gravity_compensation",
       reacting(Mode::position, {{.signal = Signal::collision, .reaction = Reaction::gravity_compensation}})},
      {"position, retreat", reacting(Mode::position, {{.signal = Signal::collision, .reaction = Reaction::retreat}})},
      {"cartesian_impedance, no reflex", reacting(Mode::cartesian_impedance, {})},
      {"cartesian_impedance, stop", robot::usual_behavior(Mode::cartesian_impedance)},
      {"joint_impedance, stop", robot::usual_behavior(Mode::joint_impedance)},
  };
  std::puts("\n| behavior | speed, m/s | clamp, N/mm | peak, N | after 2 s, N |\n|---|---|---|---|---|");
  for (const double speed : {0.1, 0.25}) {
    for (const Named& named : behaviors) clamping(named, speed, 75e3);
  }
  return 0;
}
