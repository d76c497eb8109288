// What becomes of the arm, and of what it holds, when nobody leads it any more: in the real world, with the components
// in their host as in a cell.
#include <limits>
#include <stdexcept>

#include "core/value/json.h"
#include "services/gripper/gripper.h"
#include "services/host/host.h"
#include "services/robot/robot.h"
#include "tests/unit/services/robot/rig.h"

namespace race::robot {
namespace {

using Step = std::function<void()>;

void run(double seconds, const Step& step) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / world::World::kStep)); ++i) step();
}

/// How fast the tool centre point is [m/s], over one step.
double tool_speed(const world::World& world, const Step& step) {
  const Vec3 before = world.pose("tcp").position;
  step();
  return distance(world.pose("tcp").position, before) / world::World::kStep;
}

/// How far the tool centre point goes [m] in 10 s.
double sag(const world::World& world, const Step& step) {
  const Vec3 there = world.pose("tcp").position;
  run(10, step);
  return distance(world.pose("tcp").position, there);
}

/// Robot and gripper in their host.
struct Cell final : services::HostObserver {
  Cell() {
    host.attach("robot", std::move(Robot::create(host.declare("robot", "robot", queue), *world).value()));
    host.attach("gripper", std::make_unique<gripper::Gripper>(host.declare("gripper", "gripper", queue), *world));
  }

  void step() {
    world->step();
    clock.set(world->time());
    queue.run();
    host.step(queue);
  }
  void begin(const std::string& service, const std::string& operation, std::string_view arguments) {
    answered = false;
    host.call({}, service, operation, {}, parse_json(arguments).value().as_dict());
  }
  void call(const std::string& service, const std::string& operation, std::string_view arguments) {
    begin(service, operation, arguments);
    for (int i = 0; i < 20000 && !answered; ++i) step();
    ASSERT_TRUE(answered) << operation;
    ASSERT_FALSE(refused) << operation;
  }
  /// Begins a move and lets it go on until the tool has a speed [m/s]; then both components are lost.
  void lose_in_motion(std::string_view move, double speed) {
    begin("robot", "move", move);
    double now = 0;
    for (int i = 0; i < 5000 && now < speed; ++i) now = tool_speed(*world, [this] { step(); });
    ASSERT_GE(now, speed);
    host.disconnect("robot");
    host.disconnect("gripper");
  }

  void delivered(const services::Delivery& delivery) override {
    if (delivery.kind != services::Delivery::Kind::response) return;
    answered = true;
    refused = delivery.is_error;
  }
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string&) override {}

  std::unique_ptr<world::World> world = Rig::make_world(demo_scene());
  services::WorldClock clock;
  services::WorkQueue queue;
  services::Host host{clock, *this};
  bool answered = false, refused = false;  // the last call
};

TEST(Brakes, StopAnArmThatIsLostInMotionAndHoldIt) {
  for (const char* move :
       {R"({"target": {"position": [0.5, 0.1, 0.12], "orientation": [1, 0, 0, 0]}, "speed": 1, "acceleration": 1})",
        R"({"target": {"joints": [1.4, 0.4, 0, 1.2, 0, -1.19, 0]}, "speed": 1, "acceleration": 1})"}) {
    Cell cell;
    const Step step = [&cell] { cell.step(); };
    cell.lose_in_motion(move, 0.5);
    run(0.3, step);
    EXPECT_TRUE(cell.world->braked());
    EXPECT_LT(tool_speed(*cell.world, step), 1e-3);
    EXPECT_LT(sag(*cell.world, step), 2e-3);
  }
}

TEST(Brakes, LeaveAHeldPartBetweenTheFingers) {
  Cell cell;
  const Step step = [&cell] { cell.step(); };
  cell.call("robot", "move", R"({"target": {"position": [0.55, -0.15, 0.12], "orientation": [1, 0, 0, 0]}})");
  cell.call("robot", "move", R"({"target": {"offset": [0, 0, -0.1]}})");
  cell.call("gripper", "grasp", R"({"width": 0.04})");
  cell.call("robot", "move", R"({"target": {"offset": [0, 0, 0.3]}})");
  const auto grip = [&] { return distance(cell.world->pose("cube_red").position, cell.world->pose("tcp").position); };
  const double before = grip();
  cell.lose_in_motion(R"({"target": {"joints": [1.4, -0.35, 0, 1.6, 0, -1.19, 0]}, "speed": 1, "acceleration": 1})",
                      0.5);
  run(10, step);
  EXPECT_NEAR(grip(), before, 5e-3);
}

TEST(Brakes, HoldTheArmWhereGravityPullsMost) {
  world::Scene scene = empty_scene();
  scene.robot.q = {0, M_PI / 2, 0, 0, 0, 0, 0};  // stretched out
  Rig rig(scene);
  rig.run(0.1);
  EXPECT_LT(sag(*rig.world, [&] { rig.world->step(); }), 5e-3);
  EXPECT_TRUE(rig.world->braked());
}

TEST(Brakes, AreOpenWhileTorquesAreSetAndWhereTheyNeverWere) {
  Rig rig(empty_scene());
  rig.each_step = [&] { EXPECT_FALSE(rig.world->braked()); };
  EXPECT_FALSE(rig.move({.target = Offset{{0, 0, -0.1}}, .kind = MotionKind::linear}));
  const auto bare = Rig::make_world(empty_scene());
  const Joints before = bare->q();
  run(0.5, [&] { bare->step(); });
  EXPECT_FALSE(bare->braked());
  EXPECT_GT(std::abs(bare->q()[1] - before[1]), 0.1) << "it falls";
}

TEST(Brakes, CloseAfterTheStepsThatTorquesHoldAndOpenWithTheNext) {
  Rig rig(empty_scene());
  rig.run(0.1);
  for (int i = 0; i < world::World::kTorqueTimeoutSteps; ++i) rig.world->step();
  EXPECT_FALSE(rig.world->braked());
  rig.world->step();
  EXPECT_TRUE(rig.world->braked());
  EXPECT_EQ(rig.world->torques(), Joints{}) << "the drives are off";
  EXPECT_FALSE(rig.move({.target = Offset{{0, 0, -0.1}}, .kind = MotionKind::linear}));
  EXPECT_FALSE(rig.world->braked());
}

TEST(NotFinite, TorquesReachNoDriveAndCloseTheBrakes) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = Offset{{0, 0, -0.2}}, .kind = MotionKind::linear, .speed = 1}));
  rig.run(0.4);
  ControlSettings broken = lwr_settings();
  broken.bandwidth = std::numeric_limits<double>::quiet_NaN();
  ControlUnit unit(make_arm(*rig.world), broken, rig.world->q());
  const Joints before = rig.world->torques();
  for (int i = 0; i < world::World::kTorqueTimeoutSteps; ++i) {
    EXPECT_THROW(rig.world->set_torques(unit.control(rig.world->q(), rig.world->dq())), std::domain_error);
    EXPECT_EQ(rig.world->torques(), before);
    rig.world->step();
  }
  run(0.3, [&] { rig.world->step(); });
  EXPECT_TRUE(rig.world->braked());
  EXPECT_LT(tool_speed(*rig.world, [&] { rig.world->step(); }), 1e-3);
}

TEST(NotFinite, ForcesReachNoJaw) {
  const auto world = Rig::make_world(empty_scene());
  const double width = world->gripper_width();
  for (const double force : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(world->set_gripper_force(force), std::domain_error);
  world->step();
  EXPECT_NEAR(world->gripper_width(), width, 1e-3);
}

}  // namespace
}  // namespace race::robot
