// Prints the tables of services/robot/README.md: those of collision.h, in world time, and what the control cycle costs
// this computer.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>

#include "services/robot/control_unit.h"
#include "services/world/clearance.h"
#include "services/world/world.h"
#include "tests/bench/robot/collision.h"

namespace {

using namespace race;

void detection_table() {
  std::puts(
      "| speed, m/s | contact to threshold, ms | threshold to changed command, ms | severity at once | worst |\n"
      "|---|---|---|---|---|");
  for (const double speed : robot::kDetectionSpeeds) {
    const robot::Detection found = robot::detect(speed);
    std::printf("| %.2f | %.0f | %.0f | %s | %s |\n", speed, found.to_threshold, found.to_command,
                name(found.at_once).data(), name(found.worst).data());
  }
}

void clamping_table() {
  std::puts(
      "\n| mode | on a collision | peak, N, at 0.10 m/s | after 2 s | peak, N, at 0.25 m/s | after 2 s |\n"
      "|---|---|---|---|---|---|");
  for (const robot::Clamping& row : robot::clampings()) {
    std::printf("| %s | %s |", row.mode.c_str(), row.reaction_name().c_str());
    for (const double speed : robot::kClampSpeeds) {
      const robot::ClampForce force = robot::clamp(row.behavior, speed);
      std::printf(" %.0f | %.0f |", force.peak, force.after);
    }
    std::puts("");
  }
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
  detection_table();
  clamping_table();
  cycles();
  return 0;
}
