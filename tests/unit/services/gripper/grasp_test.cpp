// Grasps on the real plant: arm, gripper and parts; what is held is held by friction.
#include <gmock/gmock.h>

#include <limits>
#include <map>

#include "services/arguments.h"
#include "services/gripper/gripper.h"
#include "services/robot/robot.h"
#include "tests/unit/services/robot/recorder.h"
#include "tests/unit/services/robot/rig.h"

namespace race::gripper {
namespace {

using services::CallId;
using world::Pose;
using world::Vec3;

/// The cell: world, robot and gripper with their services, and tasks' calls as JSON.
struct Cell {
  explicit Cell(const world::Scene& scene = robot::demo_scene())
      : world(robot::Rig::make_world(scene)), gripper(gripper_host, *world) {
    arm = std::move(robot::Robot::create(robot_host, *world).value());
  }
  ~Cell() {
    EXPECT_THAT(robot_host.violations, testing::IsEmpty());
    EXPECT_THAT(gripper_host.violations, testing::IsEmpty());
  }

  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 1000)); ++i) {
      world->step();
      arm->step();
      gripper.step();
    }
  }
  /// Calls and steps until the answer; its value, result or error.
  Value robot_call(const std::string& operation, const std::string& arguments) {
    return answer(robot_host, robot_host.call(*arm, operation, arguments));
  }
  Value gripper_call(const std::string& operation, const std::string& arguments) {
    return answer(gripper_host, gripper_host.call(gripper, operation, arguments));
  }
  Value answer(services::Recorder& host, CallId id) {
    for (int i = 0; i < 20000 && !host.answered(id); ++i) run(0.001);
    if (host.results.contains(id)) return host.results[id];
    return host.errors[id];
  }
  void move_over(const std::string& part, double height) {
    const Vec3 p = world->pose(part).position;
    const std::string at = std::to_string(p[0]) + "," + std::to_string(p[1]) + "," + std::to_string(p[2] + height);
    const Value done = robot_call("move", R"([{"position": [)" + at + R"(], "orientation": [1, 0, 0, 0]}])");
    ASSERT_EQ(done.find("code"), nullptr) << to_json(done);
  }
  void lift(double height) {
    const Value done = robot_call("move", R"([{"offset": [0, 0, )" + std::to_string(height) + "]}]");
    ASSERT_EQ(done.find("code"), nullptr) << to_json(done);
  }
  /// Opens, approaches, grasps; the answer of grasp.
  Value pick(const std::string& part, const std::string& arguments) {
    EXPECT_EQ(gripper_call("release", "[]").find("code"), nullptr);
    move_over(part, 0.1);
    lift(-0.095);
    return gripper_call("grasp", arguments);
  }
  /// Where the part is, seen from the tool but in o's directions.
  Vec3 in_tool(const std::string& part) const {
    const Vec3 a = world->pose("tcp").position;
    const Vec3 b = world->pose(part).position;
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  }

  services::Recorder robot_host{robot::model()};
  services::Recorder gripper_host{gripper::model()};
  std::unique_ptr<world::World> world;
  std::unique_ptr<robot::Robot> arm;
  Gripper gripper;
};

struct Part {
  const char* name;
  const char* arguments;
  double width;  // m between the fingers
};

class Grasp : public testing::TestWithParam<Part> {};

TEST_P(Grasp, LiftsAPartAndHoldsItWithoutSlip) {
  Cell cell;
  const Value grasped = cell.pick(GetParam().name, GetParam().arguments);
  ASSERT_EQ(grasped.find("code"), nullptr) << to_json(grasped);
  EXPECT_TRUE(grasped.find("held")->as_bool());
  EXPECT_NEAR(grasped.find("actual_width")->to_double(), GetParam().width, 1e-3);
  const double on_table = cell.world->pose(GetParam().name).position[2];
  const Vec3 before = cell.in_tool(GetParam().name);
  cell.lift(0.2);
  EXPECT_NEAR(cell.world->pose(GetParam().name).position[2], on_table + 0.2, 2e-3);
  cell.run(5);
  const double slip = robot::distance(cell.in_tool(GetParam().name), before);
  RecordProperty("slip_um", static_cast<int>(slip * 1e6));
  EXPECT_LT(slip, 2e-3);
  EXPECT_TRUE(cell.gripper_call("state", "[]").find("holding")->as_bool());
  EXPECT_EQ(cell.robot_host.counts["contact"], 0) << "its weight is no contact";
}

INSTANTIATE_TEST_SUITE_P(Parts, Grasp,
                         testing::Values(Part{"cube_red", "[0.04]", 0.04}, Part{"block_green", "[0.06, 0.1, 40]", 0.06},
                                         Part{"cube_blue", "[0.05, 0.05, 30]", 0.0707},
                                         Part{"can_yellow", "[0.04]", 0.04}),
                         [](const auto& info) { return info.param.name; });

TEST(Grasp, KeepsThePartThroughAFastMotion) {
  Cell cell;
  cell.pick("cube_red", "[0.04, 0.1, 20]");
  cell.lift(0.2);
  const Value far = cell.robot_call(
      "move", R"({"target": {"joints": [0.9, -0.5, 0.2, 1.4, 0.1, -1.2, 0.5]}, "speed": 1, "acceleration": 1})");
  ASSERT_EQ(far.find("code"), nullptr) << to_json(far);
  EXPECT_TRUE(cell.gripper_call("state", "[]").find("holding")->as_bool());
  EXPECT_LT(robot::distance(cell.world->pose("cube_red").position, cell.world->pose("tcp").position), 0.01);
}

TEST(Grasp, HoldsByFrictionAlone) {
  Cell cell;
  cell.pick("cube_red", "[0.04]");
  cell.lift(0.2);
  const double lifted = cell.world->pose("cube_red").position[2];
  ASSERT_GT(lifted, 0.2);
  cell.world->set_friction("cube_red", 0.01);
  cell.run(1);
  EXPECT_LT(cell.world->pose("cube_red").position[2], 0.05) << "it has fallen";
  EXPECT_EQ(cell.gripper_host.counts["lost"], 1);
  EXPECT_FALSE(cell.gripper_call("state", "[]").find("holding")->as_bool());
}

TEST(Grasp, HoldsAsMuchAsCoulombSays) {
  // 0.3 kg weigh 2.94 N; two fingers of 10 N hold it from a coefficient of 0.147 on.
  for (const auto& [friction, holds] : {std::pair{0.18, true}, std::pair{0.12, false}}) {
    Cell cell;
    cell.pick("block_green", "[0.06, 0.1, 10]");
    cell.lift(0.1);
    const double lifted = cell.world->pose("block_green").position[2];
    cell.world->set_friction("block_green", friction);
    cell.run(2);
    EXPECT_EQ(cell.world->pose("block_green").position[2] > lifted - 0.005, holds) << "friction " << friction;
  }
}

TEST(Grasp, PressesWithTheForceItWasAskedFor) {
  for (const double force : {5.0, 20.0, 80.0}) {
    Cell cell;
    cell.pick("block_green", "[0.06, 0.1, " + std::to_string(force) + "]");
    cell.run(0.2);
    EXPECT_NEAR(cell.world->contact_force("finger_left", "block_green"), force, 0.05 * force + 0.5);
    EXPECT_NEAR(cell.world->contact_force("finger_right", "block_green"), force, 0.05 * force + 0.5);
  }
}

TEST(Grasp, SeesThatThereIsNoPart) {
  Cell cell;
  cell.gripper_call("release", "[]");
  const Value answer = cell.gripper_call("grasp", "[0.04]");
  ASSERT_NE(answer.find("code"), nullptr) << to_json(answer);
  EXPECT_EQ(answer.find("code")->as_string(), "no_part");
  EXPECT_NEAR(answer.find("actual_width")->to_double(), 0.038, 1e-3);
  EXPECT_EQ(cell.gripper_host.state(), "Ready");
  cell.run(0.5);
  EXPECT_NEAR(cell.world->gripper_width(), 0.038, 3e-3) << "the fingers stay there";
}

TEST(Grasp, SeesThatTheFingersMeetEachOther) {
  Cell cell;
  const Value answer = cell.gripper_call("grasp", "[0]");
  ASSERT_NE(answer.find("code"), nullptr) << to_json(answer);
  EXPECT_EQ(answer.find("code")->as_string(), "no_part");
}

TEST(Release, OpensToTheWidthAndDropsThePart) {
  Cell cell;
  cell.pick("cube_red", "[0.04]");
  cell.lift(0.1);
  const Value answer = cell.gripper_call("release", "[0.08]");
  ASSERT_EQ(answer.find("code"), nullptr) << to_json(answer);
  EXPECT_NEAR(answer.find("actual_width")->to_double(), 0.08, 1e-3);
  cell.run(0.5);
  EXPECT_LT(cell.world->pose("cube_red").position[2], 0.05);
  EXPECT_EQ(cell.gripper_host.counts["lost"], 0) << "it was let go";
}

TEST(Gripper, MovesNoFasterThanAsked) {
  for (const double speed : {0.02, 0.1, 0.42}) {
    Cell cell;
    cell.gripper_call("release", "[]");
    const CallId id = cell.gripper_host.call(cell.gripper, "grasp", "[0, " + std::to_string(speed) + "]");
    double fastest = 0;
    while (!cell.gripper_host.answered(id)) {
      cell.run(0.001);
      fastest = std::max(fastest, -cell.world->gripper_speed());
    }
    EXPECT_LT(fastest, 1.1 * speed);
    EXPECT_GT(fastest, 0.5 * speed);
  }
}

TEST(Gripper, HaltsByItselfAsItsRsmAllows) {
  Cell cell;
  cell.gripper_call("release", "[]");
  const CallId id = cell.gripper_host.call(cell.gripper, "grasp", "[0, 0.05]");
  cell.run(0.5);
  cell.gripper.halt();
  EXPECT_EQ(cell.gripper_host.code(id), "stopped");
  const double width = cell.world->gripper_width();
  cell.run(0.5);
  EXPECT_NEAR(cell.world->gripper_width(), width, 2e-3);
  cell.gripper.halt();
}

TEST(Gripper, StopAnswersTheGraspAsStoppedAndStandsStill) {
  Cell cell;
  cell.gripper_call("release", "[]");
  const CallId id = cell.gripper_host.call(cell.gripper, "grasp", "[0, 0.05]");
  cell.run(0.5);
  const CallId stop = cell.gripper_host.call(cell.gripper, "stop");
  EXPECT_EQ(cell.gripper_host.code(id), "stopped");
  EXPECT_TRUE(cell.gripper_host.results.contains(stop));
  const double width = cell.world->gripper_width();
  cell.run(0.5);
  EXPECT_NEAR(cell.world->gripper_width(), width, 2e-3);
}

TEST(Gripper, StopKeepsAPartHeld) {
  Cell cell;
  cell.pick("cube_red", "[0.04]");
  cell.lift(0.1);
  cell.gripper_call("stop", "[]");
  cell.run(1);
  EXPECT_GT(cell.world->pose("cube_red").position[2], 0.1);
  EXPECT_TRUE(cell.gripper_call("state", "[]").find("holding")->as_bool());
}

TEST(Gripper, RejectsWhatItsStateDoesNotAccept) {
  Cell cell;
  cell.gripper_host.call(cell.gripper, "grasp", "[0, 0.02]");
  cell.run(0.1);
  EXPECT_EQ(cell.gripper_host.code(cell.gripper_host.call(cell.gripper, "release")), "not_accepted");
  EXPECT_FALSE(cell.gripper_call("state", "[]").find("holding")->as_bool());
}

TEST(Gripper, RefusesWrongArgumentsWithTheirNameAndNeverMoves) {
  struct Wrong {
    const char* operation;
    const char* arguments;
    const char* code;
    const char* argument;
  };
  const std::vector<Wrong> cases = {
      {"grasp", R"([0.2])", "out_of_range", "width"},
      {"grasp", R"([-0.01])", "out_of_range", "width"},
      {"grasp", R"(["wide"])", "type", "width"},
      {"grasp", R"([0.04, 0])", "out_of_range", "speed"},
      {"grasp", R"([0.04, 0.1, -5])", "out_of_range", "force"},
      {"grasp", R"([0.04, 0.1, 81])", "out_of_range", "force"},
      {"release", R"([0.12])", "out_of_range", "width"},
      {"release", R"({"speed": null})", "type", "speed"},
  };
  Cell cell;
  const double before = cell.world->gripper_width();
  for (const Wrong& wrong : cases) {
    const CallId id = cell.gripper_host.call(cell.gripper, wrong.operation, wrong.arguments);
    EXPECT_EQ(cell.gripper_host.code(id), wrong.code) << wrong.arguments;
    const Value* argument = cell.gripper_host.errors[id].find("argument");
    ASSERT_TRUE(argument) << wrong.arguments;
    EXPECT_EQ(argument->as_string(), wrong.argument);
  }
  cell.run(0.3);
  EXPECT_NEAR(cell.world->gripper_width(), before, 1e-3);
}

// JSON has no such numbers, but a task can compute them.
TEST(Gripper, RefusesWhatIsNoFiniteNumberAndNeverMoves) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::map<std::string, List> usual = {{"grasp", {Value(0.04), Value(0.1), Value(20.0)}},
                                             {"release", {Value(0.08), Value(0.1)}}};
  Cell cell;
  const double before = cell.world->gripper_width();
  CallId id = 1000;
  for (const auto& [operation, arguments] : usual) {
    const auto& parameters = services::find_operation(model(), operation)->parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
        List given = arguments;
        given[i] = Value(wrong);
        cell.gripper_host.hand_over(cell.gripper, {++id, operation, given, {}});
        EXPECT_EQ(cell.gripper_host.code(id), "out_of_range") << operation << " " << parameters[i].name << " " << wrong;
        const Value* argument = cell.gripper_host.errors[id].find("argument");
        ASSERT_TRUE(argument) << operation << " " << parameters[i].name << " " << wrong;
        EXPECT_EQ(argument->as_string(), parameters[i].name);
        EXPECT_EQ(cell.gripper_host.state(), "Ready");
        cell.run(0.05);
        EXPECT_NEAR(cell.world->gripper_width(), before, 1e-3);
      }
    }
  }
}

TEST(Cell, RepeatsAPickBitForBit) {
  const auto pick = [] {
    auto cell = std::make_unique<Cell>();
    cell->pick("cube_red", "[0.04]");
    cell->lift(0.2);
    return std::pair{cell->world->q(), cell->world->pose("cube_red")};
  };
  EXPECT_EQ(pick(), pick());
}

}  // namespace
}  // namespace race::gripper
