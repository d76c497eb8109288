// Tables of the simulated robot: how long from contact to detection for five speeds, which force it puts on a clamped
// body per behavior, both in world time; and what the control cycle costs this computer. This is a simulation and says
// nothing about a real robot's safety.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <stdexcept>

#include "services/robot/control_unit.h"
#include "services/world/clearance.h"
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
  std::string severity = "-", worst = "-";
  for (int i = 0; i < 20000 && (reacted < 0 || cell.world->time() < reacted + 0.2); ++i) {
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
      worst = name(incident.contact.severity);
      if (reacted >= 0) continue;
      reacted = cell.world->time();
      severity = worst;
    }
  }
  std::printf("| %.2f | %.0f | %.0f | %s | %s |\n", speed, (passed - contact) * 1000, (reacted - passed) * 1000,
              severity.c_str(), worst.c_str());
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

struct Force {
  double peak, after;  // N, of the clamp's spring; after 2 s
};

/// Brings the tool to `speed` until it meets the clamp: by its own motion, or by a hand that then lets go.
Force clamping(Behavior behavior, double speed) {
  Cell cell(false);
  Clamp clamp{75e3, 0.6, 40.0};  // the hand of ISO/TS 15066: 75 N/mm, 0.6 kg
  const bool led = behavior.operational.mode == Mode::gravity_compensation;
  behavior.operational.speed = speed;
  const double way = 2 * (kFace - cell.face());
  if (led) {
    cell.unit->set_behavior(behavior);
  } else {
    cell.unit->move(
        {.target = robot::Offset{{0, way, 0}}, .kind = robot::MotionKind::linear, .speed = 1, .acceleration = 1},
        behavior);
  }
  Force found{0, 0};
  double before = cell.face();
  bool met = false;
  for (int i = 0, after = 0; i < 30000 && after < 2000; ++i) {
    const double force = clamp.press(cell.face());
    met = met || force > 0;
    after += met ? 1 : 0;
    const double moves = (cell.face() - before) / 0.001;
    before = cell.face();
    const auto p = cell.world->pose("tcp").position;
    if (led && !met) cell.world->push("gripper", {0, 200 * (speed - moves), 0}, p);
    if (force > 0) cell.world->push("gripper", {0, -force, 0}, {p[0], p[1] + kHalfGripper, p[2]});
    cell.step();
    found.peak = std::max(found.peak, clamp.stiffness * clamp.y);
    found.after = std::abs(clamp.stiffness * clamp.y);
  }
  return found;
}

Behavior reacting(Mode mode, std::vector<robot::Reflex> reflexes) {
  Behavior behavior = robot::usual_behavior(mode);
  behavior.reflexes = std::move(reflexes);
  return behavior;
}

void clamping_row(const std::string& mode, const char* reaction, const Behavior& behavior) {
  const Force slow = clamping(behavior, 0.1);
  const Force fast = clamping(behavior, 0.25);
  std::printf("| %s | %s | %.0f | %.0f | %.0f | %.0f |\n", mode.c_str(), reaction, slow.peak, slow.after, fast.peak,
              fast.after);
}

void clamping_table() {
  std::puts(
      "\n| mode | on a collision | peak, N, at 0.10 m/s | after 2 s | peak, N, at 0.25 m/s | after 2 s |\n"
      "|---|---|---|---|---|---|");
  for (const Mode mode : {Mode::position, Mode::joint_impedance, Mode::cartesian_impedance}) {
    const std::string label(name(mode));
    clamping_row(label, "no reflex", reacting(mode, {}));
    for (const Reaction reaction :
         {Reaction::stop, Reaction::gravity_compensation, Reaction::retreat, Reaction::slow_down})
      clamping_row(label, name(reaction).data(), reacting(mode, {{.signal = Signal::collision, .reaction = reaction}}));
  }
  Behavior gentle = reacting(Mode::cartesian_impedance, {});
  gentle.operational.force = 20;
  clamping_row("cartesian_impedance, `force` 20", "no reflex", gentle);
  clamping_row("gravity_compensation, let go", "no reflex", robot::usual_behavior(Mode::gravity_compensation));
  clamping_row("gravity_compensation, let go", "stop",
               reacting(Mode::gravity_compensation, {{.signal = Signal::collision, .reaction = Reaction::stop}}));
}

double cpu_milliseconds(const std::function<void()>& work) {
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

void cycle_row(const char* what, std::vector<double> took) {
  std::sort(took.begin(), took.end());
  std::printf("| %s | %zu | %.3f | %.3f | %.3f |\n", what, took.size(), took[took.size() / 2],
              took[took.size() * 99 / 100], took.back());
}

/// Free motions between the two sides of a wall, each with another seed: what each control cycle took.
void cycles() {
  world::Scene scene = world::load_scene(RACE_SOURCE_DIR "/deploy/demo/scene.json").value();
  world::Body wall;
  wall.name = "wall";
  wall.shape = {world::Shape::Kind::box, {0.5, 0.04, 0.35}};
  wall.o_t_body.position = {0.6, 0, 0.175};
  scene.bodies.push_back(wall);
  const world::RobotModel model = world::load_urdf(scene.robot.urdf).value();
  world::Clearance clearance(model, scene);
  const robot::Joints left{0.7, -0.35, 0, 1.9, 0, -0.9, 0}, right{-0.7, -0.35, 0, 1.9, 0, -0.9, 0};
  std::vector<double> accepting, refusing, searching, holding, slices, checks;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    robot::ControlSettings settings = robot::lwr_settings();
    settings.seed = seed;
    int checked = 0;
    robot::ControlUnit unit(robot::ArmModel::create(model, scene.robot.o_t_base).value(), settings, left,
                            [&](const robot::Joints& q, double margin) {
                              ++checked;
                              return clearance.keeps(q, margin);
                            });
    const auto cycle = [&] { unit.control(left, {}); };
    for (int i = 0; i < 100; ++i) holding.push_back(cpu_milliseconds(cycle));
    const robot::Pose inside{{0.6, 0, 0.1 + 0.004 * seed}, {1, 0, 0, 0}};
    refusing.push_back(cpu_milliseconds([&] { unit.move({.target = inside, .kind = robot::MotionKind::free}); }));
    accepting.push_back(cpu_milliseconds([&] { unit.move({.target = right, .kind = robot::MotionKind::free}); }));
    int count = 0;
    do {
      checked = 0;
      searching.push_back(cpu_milliseconds(cycle));
      checks.push_back(checked);
      count += checked > 0 ? 1 : 0;
    } while (checked > 0);
    slices.push_back(count);
  }
  std::puts("\n| CPU time on this computer | count | median, ms | 99 %, ms | longest, ms |\n|---|---|---|---|---|");
  cycle_row("control cycle, holding", holding);
  cycle_row("control cycle, searching", searching);
  cycle_row("accepting a free move", accepting);
  cycle_row("refusing one into the wall", refusing);
  std::printf("Checks of clearance in a cycle: at most %.0f; cycles of a search: at most %.0f.\n",
              *std::max_element(checks.begin(), checks.end()), *std::max_element(slices.begin(), slices.end()));
}

}  // namespace

int main() {
  std::puts(
      "| speed, m/s | contact to threshold, ms | threshold to changed command, ms | severity, at once | worst |\n"
      "|---|---|---|---|---|");
  for (const double speed : {0.05, 0.1, 0.2, 0.35, 0.5}) detection(speed);
  clamping_table();
  cycles();
  return 0;
}
