// The operations `guide` and `state` of the service `robot`, as tasks and people at the controls meet them.
#include "tests/unit/services/robot/robot_service.h"

namespace race::robot {
namespace {

struct GuidingService : RobotService {
  /// Holds the button while a hand pulls the tool along y [N].
  void guide(double seconds, double force) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 1000)); ++i) {
      if (i % 50 == 0) {
        const CallId id = call("guide");
        ASSERT_EQ(host.results[id], Value(nullptr)) << "at once";
        ASSERT_EQ(host.state(), "Guiding");
      }
      world->push("gripper", {0, force, 0}, world->pose("tcp").position);
      run(0.001);
    }
  }
  double y() const { return world->pose("tcp").position[1]; }
};

TEST_F(GuidingService, FollowsAHandAndIsIdleWhenItStands) {
  const double from = y();
  guide(1, 15);
  EXPECT_GT(y(), from + 0.05);
  run(0.19);
  EXPECT_EQ(host.state(), "Guiding") << "the last call has its 0.25 s";
  run(0.2);
  EXPECT_EQ(host.state(), "Idle");
  for (const double speed : world->dq()) EXPECT_LT(std::abs(speed), 0.02);
  const Joints held = world->q();
  run(1);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(world->q()[i], held[i], 1e-4);
  finish(call("move", R"([{"offset": [0, 0, 0.02]}])"));
}

TEST_F(GuidingService, AcceptsWhatDoesNotMoveItMeanwhile) {
  guide(0.5, 10);
  EXPECT_EQ(host.code(call("move", R"([{"offset": [0, 0, 0.02]}])")), "not_accepted");
  EXPECT_EQ(host.code(call("jog", R"({"linear": [0, 0.1, 0]})")), "not_accepted");
  EXPECT_EQ(host.code(call("change_behavior", R"(["position"])")), "not_accepted");
  EXPECT_EQ(host.code(call("speed_override", "[0]")), "");
  EXPECT_EQ(host.state(), "Guiding");
  const CallId pose = call("record_pose");
  ASSERT_TRUE(host.results.contains(pose)) << host.code(pose);
  EXPECT_EQ(host.results[pose].find("q")->as_list()[0].to_double(), world->q()[0]);
  run(0.22);
  EXPECT_EQ(host.code(call("record_pose")), "") << "also while it brakes";
  const double paused = y();
  guide(0.5, 15);
  EXPECT_GT(y(), paused + 0.02) << "a share of 0 does not stop a hand";
}

TEST_F(GuidingService, EndsAtOnceByAStopOrByItself) {
  for (const bool halt : {false, true}) {
    guide(0.5, 10);
    if (halt)
      robot->halt();
    else
      call("stop");
    EXPECT_EQ(host.state(), "Idle");
    run(0.2);
    for (const double speed : world->dq()) EXPECT_LT(std::abs(speed), 0.01);
    EXPECT_EQ(host.state(), "Idle");
  }
}

TEST_F(GuidingService, IsRefusedWithArgumentsAndInGravityCompensation) {
  EXPECT_EQ(host.code(call("guide", "[17]")), "type");
  EXPECT_EQ(host.state(), "Idle");
  guide(0.2, 0);
  EXPECT_EQ(host.code(call("guide", "[17]")), "type");
  EXPECT_EQ(host.state(), "Guiding") << "by the call before";
  run(0.5);
  call("change_behavior", R"(["gravity_compensation"])");
  EXPECT_EQ(host.code(call("guide")), "behavior");
  EXPECT_EQ(host.state(), "Idle");
}

TEST_F(GuidingService, IsRefusedAfterAReflexUntilThePersonHasLetGo) {
  const std::string wall = std::to_string(y() + 0.05);
  call("change_behavior", R"([{"operational": {"mode": "position"}, "reflexes": [{"signal": "virtual_wall",
      "reaction": "stop", "wall": {"point": [0, )" +
                              wall + R"(, 0], "normal": [0, -1, 0]}}]}])");
  for (int i = 0; i < 3000 && host.counts["virtual_wall"] == 0; ++i) {
    if (i % 50 == 0) call("guide");
    world->push("gripper", {0, 20, 0}, world->pose("tcp").position);
    run(0.001);
  }
  ASSERT_EQ(host.counts["virtual_wall"], 1);
  EXPECT_EQ(host.state(), "Idle");
  const CallId again = call("guide");
  EXPECT_EQ(host.code(again), "virtual_wall");
  EXPECT_EQ(host.errors[again].find("reaction")->as_string(), "stop");
  run(0.26);
  EXPECT_EQ(host.code(call("guide")), "");
  EXPECT_EQ(host.state(), "Guiding");
}

/// Whether it moves, and its mode, as `state` says.
TEST_F(GuidingService, SaysItsStateInEveryState) {
  const auto said = [this] {
    const CallId id = call("state");
    EXPECT_TRUE(host.results.contains(id)) << "at once";
    const Value& state = host.results[id];
    EXPECT_EQ(state.find("q")->as_list()[0].to_double(), world->q()[0]);
    EXPECT_EQ(state.find("pose")->find("position")->as_list().size(), 3U);
    return state.find("mode")->as_string() + (state.find("moving")->as_bool() ? " moving" : "");
  };
  EXPECT_EQ(said(), "position");
  call("change_behavior", R"(["joint_impedance"])");
  run(0.3);
  EXPECT_EQ(said(), "joint_impedance");
  const CallId move = call("move", R"({"target": {"offset": [0, 0.05, 0]}})");
  run(0.1);
  EXPECT_EQ(said(), "joint_impedance moving");
  EXPECT_EQ(host.state(), "Moving");
  finish(move);
  call("jog", R"({"linear": [0, 0.1, 0]})");
  run(0.1);
  EXPECT_EQ(said(), "joint_impedance moving");
  EXPECT_EQ(host.state(), "Jogging");
  call("stop");
  EXPECT_EQ(said(), "position");
  guide(0.1, 0);
  EXPECT_EQ(said(), "gravity_compensation moving");
  EXPECT_EQ(host.state(), "Guiding");
}

}  // namespace
}  // namespace race::robot
