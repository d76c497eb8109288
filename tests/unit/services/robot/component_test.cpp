// The service `robot` as tasks meet it: operations, responses, events; the monitor watches every announcement.
#include <limits>
#include <random>

#include "tests/unit/services/robot/robot_service.h"

namespace race::robot {
namespace {

constexpr const char* kDownPose = R"([{"position": [0.5, 0.1, 0.25], "orientation": [1, 0, 0, 0]}])";

TEST_F(RobotService, AnswersAMoveOnArrivalWithPoseAndJoints) {
  const CallId id = call("move", kDownPose);
  EXPECT_EQ(host.state(), "Moving");
  EXPECT_FALSE(host.answered(id));
  finish(id);
  ASSERT_EQ(host.code(id), "") << to_json(host.errors[id]);
  EXPECT_EQ(host.state(), "Idle");
  const Value* position = host.results[id].find("pose")->find("position");
  EXPECT_NEAR(position->as_list()[0].to_double(), 0.5, 1e-3);
  EXPECT_NEAR(world->pose("tcp").position[1], 0.1, 1e-3);
  EXPECT_EQ(host.results[id].find("q")->as_list().size(), 7U);
}

TEST_F(RobotService, MovesByAnOffsetOnAStraightLine) {
  const Vec3 before = world->pose("tcp").position;
  double sideways = 0;
  const CallId id = call("move", R"({"target": {"offset": [0, 0, -0.12]}})");
  for (int i = 0; i < 5000 && !host.answered(id); ++i) {
    run(0.001);
    const Vec3 now = world->pose("tcp").position;
    sideways = std::max(sideways, std::hypot(now[0] - before[0], now[1] - before[1]));
  }
  ASSERT_TRUE(host.results.contains(id));
  EXPECT_NEAR(world->pose("tcp").position[2], before[2] - 0.12, 1e-3);
  EXPECT_LT(sideways, 1e-3);
}

TEST_F(RobotService, HaltsByItselfAsItsRsmAllows) {
  const CallId moving = call("move", kDownPose);
  run(0.5);
  robot->halt();
  EXPECT_EQ(host.code(moving), "stopped");
  EXPECT_EQ(host.state(), "Idle");
  run(0.5);
  const Joints before = world->q();
  run(0.5);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(world->q()[i], before[i], 1e-4);
  robot->halt();
  finish(call("move", kDownPose));
}

TEST_F(RobotService, StopAnswersTheMoveAsStoppedAndIsAcceptedAlways) {
  const CallId moving = call("move", kDownPose);
  run(0.5);
  const CallId stop = call("stop");
  EXPECT_EQ(host.code(moving), "stopped");
  EXPECT_TRUE(host.results.contains(stop));
  EXPECT_EQ(host.state(), "Idle");
  run(1);
  for (const double speed : world->dq()) EXPECT_LT(std::abs(speed), 0.01);
  EXPECT_TRUE(host.results.contains(call("stop")));
}

TEST_F(RobotService, RejectsWhatItsStateDoesNotAccept) {
  call("move", kDownPose);
  run(0.1);
  EXPECT_EQ(host.code(call("move", kDownPose)), "not_accepted");
  EXPECT_EQ(host.code(call("change_behavior", R"(["gravity_compensation"])")), "not_accepted");
  EXPECT_EQ(host.code(call("record_pose")), "not_accepted");
  EXPECT_EQ(host.code(call("dance")), "not_accepted");
}

TEST_F(RobotService, RefusesWrongArgumentsWithTheirNameAndNeverMoves) {
  struct Wrong {
    const char* arguments;
    const char* code;
    const char* argument;
  };
  const std::vector<Wrong> cases = {
      {R"([])", "missing", "target"},
      {R"([17])", "type", "target"},
      {R"([{"joints": [0, 0, 0]}])", "type", "target"},
      {R"([{"joints": [0, 0, 0, "a", 0, 0, 0]}])", "type", "target"},
      {R"([{"joints": [0, 0, 0, 9, 0, 0, 0]}])", "joint_limits", "target"},
      {R"([{"position": [0.5, 0, 0.2]}])", "type", "target"},
      {R"([{"position": [0.5, 0, 0.2], "orientation": [0, 0, 0, 0]}])", "out_of_range", "target"},
      {R"([{"position": [1.5, 0, 0.2], "orientation": [1, 0, 0, 0]}])", "unreachable", "target"},
      {R"([{"offset": [0, 0, 0.1], "joints": [0, 0, 0, 0, 0, 0, 0]}])", "type", "target"},
      {R"({"target": {"offset": [0, 0, 0.1]}, "kind": "circular"})", "type", "kind"},
      {R"({"target": {"offset": [0, 0, 0.1]}, "speed": 0})", "out_of_range", "speed"},
      {R"({"target": {"offset": [0, 0, 0.1]}, "speed": 1.5})", "out_of_range", "speed"},
      {R"({"target": {"offset": [0, 0, 0.1]}, "acceleration": "fast"})", "type", "acceleration"},
      {R"([{"position": [500, 100, 250], "orientation": [1, 0, 0, 0]}])", "unreachable", "target"},  // mm
      {R"([{"offset": [0, 0, 100]}])", "unreachable", "target"},                                     // mm
      {R"([{"joints": [0, -20, 0, 90, 0, -68, 0]}])", "joint_limits", "target"},                     // degrees
      {R"({"target": {"position": [1.5, 0, 0.2], "orientation": [1, 0, 0, 0]}, "kind": "free"})", "unreachable",
       "target"},
      {R"({"target": {"offset": [0, 0, 0.1]}, "velocity": 0.1})", "type", ""},
      {R"([{"offset": [0, 0, 0.1]}, {"operational": {"mode": "dance"}}])", "type", "behavior"},
      {R"([{"offset": [0, 0, 0.1]}, {"operational": {"mode": "position"},
          "reflexes": [{"signal": "force_limit", "force": -5, "reaction": "stop"}]}])",
       "out_of_range", "behavior"},
      {R"([{"offset": [0, 0, 0.1]}, {"operational": {"mode": "position"},
          "reflexes": [{"signal": "collision", "severity": "deadly", "reaction": "stop"}]}])",
       "type", "behavior"},
      {R"({"target": {"joints": [1, 0, 0, 1.6, 0, -1, 0]}, "carried": {"box": [0.1, 0.1, 0.1]}})", "type", "carried"},
      {R"({"target": {"joints": [1, 0, 0, 1.6, 0, -1, 0]}, "kind": "free", "carried": {"box": [50, 50, 50]}})",
       "out_of_range", "carried"},
      {R"([{"offset": [0, 0, 0.1]}, {"operational": {"mode": "joint_impedance", "damping": -1}}])", "out_of_range",
       "behavior"},
  };
  const Joints before = world->q();
  for (const Wrong& wrong : cases) {
    const CallId id = call("move", wrong.arguments);
    EXPECT_EQ(host.code(id), wrong.code) << wrong.arguments;
    const Value* argument = host.errors[id].find("argument");
    EXPECT_EQ(argument ? argument->as_string() : "", wrong.argument) << wrong.arguments;
    EXPECT_FALSE(host.errors[id].find("message")->as_string().empty()) << wrong.arguments;
    EXPECT_EQ(host.state(), "Idle");
  }
  run(0.5);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(world->q()[i], before[i], 1e-6);
}

TEST_F(RobotService, RefusesWrongArgumentsOfItsOtherOperations) {
  struct Wrong {
    const char* operation;
    const char* arguments;
    const char* code;
  };
  const std::vector<Wrong> cases = {
      {"change_behavior", R"([])", "missing"},
      {"change_behavior", R"([{"operational": {"mode": "position", "stiffness": [1, 1, 1, 1, 1, 1]}}])", "type"},
      {"change_behavior", R"([{"operational": {"mode": "cartesian_impedance", "limits": {"force": -1}}}])",
       "out_of_range"},
      {"change_behavior", R"(["position", "position"])", "type"},
      {"speed_override", R"([])", "missing"},
      {"speed_override", R"(["half"])", "type"},
      {"speed_override", R"([-0.1])", "out_of_range"},
      {"speed_override", R"([50])", "out_of_range"},  // percent
      {"record_pose", R"([17])", "type"},
      {"jog", R"([])", "type"},
      {"jog", R"({"frame": "tool"})", "type"},
      {"jog", R"({"joints": null, "linear": null})", "type"},
      {"jog", R"({"joints": [0.1, 0, 0, 0, 0, 0, 0], "angular": [0, 0, 0.1]})", "type"},
      {"jog", R"({"joints": [0.1, 0, 0]})", "type"},
      {"jog", R"({"linear": [0, 0.1, "up"]})", "type"},
      {"jog", R"({"linear": [0, 0.1, 0], "frame": "camera"})", "type"},
      {"jog", R"({"linear": [0, 250, 0]})", "out_of_range"},                         // mm/s
      {"jog", R"({"linear": [0, 0.1, 0], "angular": [0, 0, 30]})", "out_of_range"},  // degrees
      {"jog", R"({"joints": [0, 0, 0, 0, 0, 0, 2]})", "out_of_range"},
  };
  const Joints before = world->q();
  for (const Wrong& wrong : cases) {
    const CallId id = call(wrong.operation, wrong.arguments);
    EXPECT_EQ(host.code(id), wrong.code) << wrong.operation << wrong.arguments;
    EXPECT_FALSE(host.errors[id].find("message")->as_string().empty());
  }
  EXPECT_EQ(host.code(call("record_pose")), "behavior") << "none of them changed the behavior";
  run(0.5);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(world->q()[i], before[i], 1e-6);
  const CallId move = call("move", R"({"target": {"offset": [0, 0.05, 0]}, "speed": 1})");
  run(1);
  EXPECT_TRUE(host.results.contains(move)) << "nor the speed";
}

/// `value` with its `left`-th number replaced by `bad`; counts `left` down.
Value spoiled(const Value& value, int& left, double bad) {
  if (value.is_numeric()) return left-- == 0 ? Value(bad) : value;
  if (value.is_list()) {
    List items;
    for (const Value& item : value.as_list()) items.push_back(spoiled(item, left, bad));
    return items;
  }
  if (!value.is_dict()) return value;
  Dict fields;
  for (const auto& [key, field] : value.as_dict()) fields.set(key.as_string(), spoiled(field, left, bad));
  return fields;
}

TEST_F(RobotService, RefusesANumberThatIsNotFiniteWhereverItStands) {
  struct Right {
    const char* operation;
    const char* arguments;
  };
  const std::vector<Right> cases = {
      {"move", R"({"target": {"position": [0.5, 0.1, 0.25], "orientation": [1, 0, 0, 0]}, "speed": 0.3,
          "acceleration": 0.4, "kind": "free", "carried": {"box": [0.05, 0.05, 0.05]}, "behavior": {
          "operational": {"mode": "cartesian_impedance", "stiffness": [500, 500, 500, 50, 50, 50], "damping": 0.7,
                          "limits": {"speed": 0.2, "force": 40}},
          "reflexes": [{"signal": "force_limit", "force": 30, "reaction": "retreat", "distance": 0.1},
                       {"signal": "joint_limit", "margin": 0.1, "reaction": "slow_down", "scale": 0.5},
                       {"signal": "virtual_wall", "wall": {"point": [0, 2, 0], "normal": [0, -1, 0]},
                        "reaction": "stop"},
                       {"signal": "virtual_wall", "wall": {"min": [1, 1, 1], "max": [2, 2, 2]},
                        "reaction": "stop"}]}})"},
      {"move", R"({"target": {"joints": [0, -0.3, 0, 1.5, 0, -1.1, 0]}})"},
      {"move", R"({"target": {"offset": [0, 0.05, 0.05]}})"},
      {"change_behavior", R"({"behavior": {"operational": {"mode": "joint_impedance",
          "stiffness": [500, 500, 300, 300, 100, 80, 80]}}})"},
      {"speed_override", R"({"share": 0.5})"},
      {"jog", R"({"joints": [0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1]})"},
      {"jog", R"({"linear": [0, 0.1, 0.1], "angular": [0, 0.1, 0.1], "frame": "tool"})"},
  };
  services::CallId id = 1000;
  int refused = 0;
  const Joints before = world->q();
  for (const Right& right : cases) {
    const Value arguments = parse_json(right.arguments).value();
    for (int number = 0;; ++number) {
      int left = number;
      static_cast<void>(spoiled(arguments, left, 0));
      if (left >= 0) break;  // it has no more numbers
      for (const double bad : {NAN, INFINITY, -INFINITY}) {
        left = number;
        services::Call call{++id, right.operation, {}, spoiled(arguments, left, bad).as_dict()};
        host.hand_over(*robot, call);
        EXPECT_EQ(host.code(id), "out_of_range") << right.operation << " number " << number << " " << bad;
        EXPECT_TRUE(host.errors[id].find("argument")) << right.operation << " number " << number;
        EXPECT_EQ(host.state(), "Idle");
        ++refused;
      }
    }
  }
  EXPECT_EQ(refused, 3 * (7 + 2 + 3 + 9 + 2 + 2 + 6 + 6 + 7 + 3 + 7 + 1 + 7 + 6));
  run(0.5);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(world->q()[i], before[i], 1e-6);
  for (const Right& right : cases) {
    const CallId accepted = call(right.operation, right.arguments);
    EXPECT_EQ(host.code(accepted), "") << right.operation << ": " << to_json(host.errors[accepted]);
    call("stop");
  }
}

TEST_F(RobotService, AnswersAnyTargetAndNeverLeavesItsLimits) {
  constexpr unsigned seed = 99;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  using Limits = std::numeric_limits<double>;
  const std::vector<double> odd = {
      0, -0.0, 1e-300, 1e300, -1e18, 0.5, 1, M_PI, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()};
  const auto number = [&] {
    if (random() % 4 == 0) return Value(odd[random() % odd.size()]);
    if (random() % 20 == 0) return Value("one");
    return Value(std::uniform_real_distribution(-1.0, 1.0)(random));
  };
  const auto numbers = [&](std::size_t count) {
    List list;
    for (std::size_t i = random() % 15 == 0 ? 1 : 0; i < count; ++i) list.push_back(number());
    return Value(list);
  };
  int accepted = 0;
  for (int i = 0; i < 300; ++i) {
    Value target;
    switch (random() % 4) {
      case 0:
        target = Dict{{"joints", numbers(7)}};
        break;
      case 1:
        target = Dict{{"offset", numbers(3)}};
        break;
      case 2:
        target = Dict{{"position", numbers(3)}, {"orientation", numbers(4)}};
        break;
      default:
        target = Dict{{"position", numbers(3)}, {"orientation", List{Value(1), Value(0), Value(0), Value(0)}}};
    }
    services::Call call{1000000U + static_cast<CallId>(i), "move", {target}, {}};
    if (random() % 3 == 0) call.kwargs.set("speed", number());
    if (random() % 3 == 0) call.kwargs.set("kind", Value(random() % 2 == 0 ? "lin" : "ptp"));
    host.hand_over(*robot, call);
    run(0.05);
    accepted += host.answered(call.id) ? 0 : 1;
    this->call("stop");
    ASSERT_TRUE(host.answered(call.id)) << "case " << i;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      ASSERT_TRUE(std::isfinite(world->torques()[joint])) << "case " << i;
      ASSERT_LE(std::abs(world->dq()[joint]), 4) << "case " << i;
    }
  }
  EXPECT_GT(accepted, 20) << "the cases reach motions, too";
  EXPECT_LT(accepted, 280);
}

TEST_F(RobotService, SamplesItsStateAHundredTimesASecond) {
  run(1);
  EXPECT_EQ(host.counts["robot_state"], 100);
  EXPECT_EQ(host.events["robot_state"].find("f_ext_hat")->as_list().size(), 3U);
}

TEST_F(RobotService, TellsAContactWithForceAndLink) {
  for (int i = 0; i < 500; ++i) {
    world->push("gripper", {0, 25, 0}, world->pose("tcp").position);
    run(0.001);
  }
  ASSERT_EQ(host.counts["contact"], 1);
  EXPECT_GT(host.events["contact"].find("f_ext_hat")->as_list()[1].to_double(), 5);
  EXPECT_EQ(host.events["contact"].find("link")->as_string().substr(0, 5), "link_");
}

TEST_F(RobotService, TellsACollisionAfterItReactedAndAnswersTheMoveWithIt) {
  const CallId id = call("move", R"([{"offset": [0, 0.3, 0]}, {"operational": {"mode": "position"},
      "reflexes": [{"signal": "collision", "reaction": "gravity_compensation"}]}])");
  run(0.5);
  ASSERT_FALSE(host.answered(id));
  for (int i = 0; i < 100 && !host.answered(id); ++i) {
    world->push("gripper", {0, -60, 0}, world->pose("tcp").position);
    run(0.001);
  }
  EXPECT_EQ(host.code(id), "collision") << to_json(host.errors[id]);
  EXPECT_EQ(host.errors[id].find("reaction")->as_string(), "gravity_compensation");
  ASSERT_EQ(host.counts["collision"], 1);
  const Value& event = host.events["collision"];
  EXPECT_EQ(event.find("reaction")->as_string(), "gravity_compensation");
  EXPECT_EQ(event.find("classification")->as_string(), "accidental");
  EXPECT_EQ(event.find("tau_ext_hat")->as_list().size(), 7U);
  EXPECT_EQ(host.state(), "Idle");
}

TEST_F(RobotService, PublishesHowItIsControlledOnlyWhileSomebodyListens) {
  run(1);
  EXPECT_THAT(host.packets, testing::IsEmpty());
  robot->demand_changed("control", true);
  run(1);
  ASSERT_EQ(host.packets["control"].size(), 5U);
  const auto now = [this] { return host.packets["control"].back()->header; };
  EXPECT_EQ(to_json(now()), R"({"mode":"position","moving":false,"speed_override":1.0})");
  call("change_behavior", R"([{"operational": {"mode": "cartesian_impedance", "limits": {"force": 20}}}])");
  run(0.2);
  EXPECT_EQ(now().find("mode")->as_string(), "cartesian_impedance");
  EXPECT_EQ(now().find("force")->to_double(), 20);
  call("move", kDownPose);
  run(0.2);
  EXPECT_TRUE(now().find("moving")->as_bool());
  robot->demand_changed("control", false);
  const auto before = host.packets["control"].size();
  run(1);
  EXPECT_EQ(host.packets["control"].size(), before);
}

TEST_F(RobotService, PublishesTheModeThatAReflexChoseAndTheCollision) {
  robot->demand_changed("control", true);
  const CallId id = call("move", R"([{"offset": [0, 0.3, 0]}, {"operational": {"mode": "position"},
      "reflexes": [{"signal": "collision", "reaction": "gravity_compensation"}]}])");
  run(0.5);
  for (int i = 0; i < 100 && !host.answered(id); ++i) {
    world->push("gripper", {0, -60, 0}, world->pose("tcp").position);
    run(0.001);
  }
  const double felt = host.time;
  run(0.3);
  const Value& header = host.packets["control"].back()->header;
  EXPECT_EQ(header.find("mode")->as_string(), "gravity_compensation");
  const Value* collision = header.find("collision");
  ASSERT_NE(collision, nullptr);
  EXPECT_EQ(collision->find("link")->as_string(), host.events["collision"].find("link")->as_string());
  EXPECT_NEAR(collision->find("time")->to_double(), felt, 0.002);
}

TEST_F(RobotService, TellsForceLimitsWallsAndJointLimitsWithWhatTheyAreAbout) {
  const auto interrupted = [&](const char* reflex, const Vec3& force) {
    const CallId id = call("move", R"([{"joints": [0.9, -0.35, 0, 1.6, 0, -2.05, 0]},
        {"operational": {"mode": "position"}, "reflexes": [)" +
                                       std::string(reflex) + "]}]");
    for (int i = 0; i < 20000 && !host.answered(id); ++i) {
      world->push("gripper", force, world->pose("tcp").position);
      run(0.001);
    }
    const std::string code = host.code(id);
    finish(call("move", R"([{"joints": [0, -0.35, 0, 1.6, 0, -1.19, 0]}, {"operational": {"mode": "position"}}])"));
    return code;
  };
  EXPECT_EQ(interrupted(R"({"signal": "force_limit", "force": 15, "reaction": "stop"})", {0, -20, 0}), "force_limit");
  const Value& force = host.events["force_limit"];
  EXPECT_EQ(force.find("reaction")->as_string(), "stop");
  EXPECT_LT(force.find("f_ext_hat")->as_list()[1].to_double(), -10);

  EXPECT_EQ(interrupted(R"({"signal": "virtual_wall", "wall": {"point": [0, 0.2, 0], "normal": [0, -1, 0]},
      "reaction": "retreat"})",
                        {}),
            "virtual_wall");
  const Value& wall = host.events["virtual_wall"];
  EXPECT_EQ(wall.find("reaction")->as_string(), "retreat");
  EXPECT_NEAR(wall.find("pose")->find("position")->as_list()[1].to_double(), 0.2, 0.1);

  EXPECT_EQ(interrupted(R"({"signal": "joint_limit", "reaction": "gravity_compensation"})", {}), "joint_limit");
  const Value& limit = host.events["joint_limit"];
  EXPECT_EQ(limit.find("reaction")->as_string(), "gravity_compensation");
  EXPECT_EQ(limit.find("joint")->to_double(), 6);
  EXPECT_LT(limit.find("q")->as_list()[5].to_double(), -1.8);
}

TEST_F(RobotService, StopIsAcceptedInEveryModeAndOnTheWayBackAndHolds) {
  for (const char* mode : {"position", "joint_impedance", "cartesian_impedance", "gravity_compensation"}) {
    call("change_behavior", "[\"" + std::string(mode) + "\"]");
    run(0.3);
    EXPECT_TRUE(host.results.contains(call("stop"))) << mode;
    run(0.3);
    const double there = world->pose("tcp").position[1];
    for (int i = 0; i < 500; ++i) {
      world->push("gripper", {0, 10, 0}, world->pose("tcp").position);
      run(0.001);
    }
    EXPECT_NEAR(world->pose("tcp").position[1], there, 2e-3) << mode << ": it holds against a hand";
    run(0.5);
  }
  const CallId id =
      call("move", R"([{"joints": [0.9, -0.35, 0, 1.6, 0, -1.19, 0]}, {"operational": {"mode": "position"},
      "reflexes": [{"signal": "virtual_wall", "wall": {"point": [0, 0.2, 0], "normal": [0, -1, 0]},
                    "reaction": "retreat", "distance": 0.2}]}])");
  for (int i = 0; i < 5000 && host.counts["virtual_wall"] == 0; ++i) run(0.001);
  run(0.2);
  EXPECT_FALSE(host.answered(id)) << "it goes back";
  EXPECT_EQ(host.code(call("move", kDownPose)), "not_accepted");
  EXPECT_TRUE(host.results.contains(call("stop")));
  EXPECT_EQ(host.code(id), "stopped");
  run(0.3);
  const Joints held = world->q();
  run(0.5);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(world->q()[i], held[i], 1e-4);
}

TEST_F(RobotService, RecordsPosesWhileItIsLedByHand) {
  EXPECT_EQ(host.code(call("record_pose")), "behavior");
  call("change_behavior", R"([{"operational": {"mode": "gravity_compensation"}}])");
  for (int i = 0; i < 500; ++i) {
    world->push("gripper", {0, 15, 0}, world->pose("tcp").position);
    run(0.001);
  }
  const CallId id = call("record_pose");
  ASSERT_TRUE(host.results.contains(id));
  const Value* position = host.results[id].find("pose")->find("position");
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(position->as_list()[i].to_double(), world->pose("tcp").position[i], 1e-6);
  EXPECT_EQ(host.results[id].find("q")->as_list()[0].to_double(), world->q()[0]);
}

TEST_F(RobotService, ScalesItsSpeedAlsoWhileItMoves) {
  EXPECT_EQ(host.code(call("speed_override", "[1.2]")), "out_of_range");
  const CallId move = call("move", kDownPose);
  run(0.3);
  EXPECT_TRUE(host.results.contains(call("speed_override", "[0]")));
  run(0.3);
  const Joints paused = world->q();
  run(1);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(world->q()[i], paused[i], 1e-3);
  EXPECT_EQ(host.state(), "Moving");
  EXPECT_FALSE(host.answered(move));
  call("speed_override", "[1]");
  finish(move);
  EXPECT_EQ(host.code(move), "");
}

TEST_F(RobotService, FindsItsWayAroundTheCell) {
  const CallId id = call("move", R"({"target": {"joints": [1.2, -0.6, 0, 1.4, 0, -1.1, 0]}, "kind": "free"})");
  EXPECT_EQ(host.state(), "Moving");
  finish(id);
  EXPECT_EQ(host.code(id), "") << to_json(host.errors[id]);
}

TEST_F(RobotService, FindsItsWayForWhatItCarriesToo) {
  // A post beside the target: the jaws fit in front of it, a wide part does not.
  world::Scene scene = empty_scene();
  scene.bodies.push_back(fixed_box("post", {0.05, 0.05, 0.6}, {0.55, 0.42, 0.3}));
  world = Rig::make_world(scene);
  robot = std::move(Robot::create(host, *world).value());
  const std::string target =
      R"("target": {"position": [0.55, 0.25, 0.3], "orientation": [1, 0, 0, 0]}, "kind": "free")";
  const CallId wide = call("move", "{" + target + R"(, "carried": {"box": [0.3, 0.3, 0.05]}})");
  EXPECT_EQ(host.code(wide), "path") << "the part would be in the post";
  const CallId empty = call("move", "{" + target + "}");
  finish(empty);
  EXPECT_EQ(host.code(empty), "") << "a part is forgotten with the next move: " << to_json(host.errors[empty]);
  finish(call("move", R"({"target": {"offset": [0, 0, 0.05]}})"));
  const CallId narrow = call("move", "{" + target + R"(, "carried": {"box": [0.05, 0.05, 0.05]}})");
  finish(narrow);
  EXPECT_EQ(host.code(narrow), "") << to_json(host.errors[narrow]);
}

TEST_F(RobotService, CanBeLedByHandAndHoldsAgainAfterwards) {
  const CallId free = call("change_behavior", R"(["gravity_compensation"])");
  EXPECT_TRUE(host.results.contains(free));
  EXPECT_EQ(host.code(call("move", kDownPose)), "behavior");
  const double before = world->pose("tcp").position[1];
  for (int i = 0; i < 1000; ++i) {
    world->push("gripper", {0, 15, 0}, world->pose("tcp").position);
    run(0.001);
  }
  EXPECT_GT(world->pose("tcp").position[1], before + 0.05);
  EXPECT_EQ(host.code(call("change_behavior", R"(["dance"])")), "type");
  call("change_behavior", R"(["position"])");
  run(0.5);
  const Joints held = world->q();
  run(1);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(world->q()[i], held[i], 1e-4);
}

// ---- Jogging.

constexpr const char* kSideways = R"({"linear": [0, 0.2, 0]})";

TEST_F(RobotService, JogsWhileItIsCalledAgainAndIsIdleWhenItStands) {
  const double from = world->pose("tcp").position[1];
  for (int i = 0; i < 20; ++i) {
    const CallId id = call("jog", kSideways);
    EXPECT_EQ(host.results[id], Value(nullptr)) << "at once";
    EXPECT_EQ(host.state(), "Jogging");
    run(0.05);
  }
  EXPECT_NEAR(world->pose("tcp").position[1] - from, 0.2, 0.02);
  run(0.2);
  EXPECT_EQ(host.state(), "Jogging");
  run(0.15);
  EXPECT_EQ(host.state(), "Idle");
  for (const double speed : world->dq()) EXPECT_LT(std::abs(speed), 0.02);
  finish(call("move", kDownPose));
}

TEST_F(RobotService, AcceptsTheNextVelocityAStopAndTheOverrideWhileItJogs) {
  call("jog", kSideways);
  run(0.2);
  EXPECT_EQ(host.code(call("move", kDownPose)), "not_accepted");
  EXPECT_EQ(host.code(call("change_behavior", R"(["gravity_compensation"])")), "not_accepted");
  EXPECT_EQ(host.code(call("record_pose")), "not_accepted");
  EXPECT_EQ(host.code(call("speed_override", "[0.5]")), "");
  EXPECT_EQ(host.state(), "Jogging");
  EXPECT_EQ(host.code(call("jog", R"({"joints": [-0.5, 0, 0, 0, 0, 0, 0]})")), "");
  run(0.24);
  EXPECT_LT(world->dq()[0], -0.2);
  EXPECT_GT(world->dq()[0], -0.3) << "half of what is wanted";
  EXPECT_TRUE(host.results.contains(call("stop")));
  EXPECT_EQ(host.state(), "Idle");
  run(0.2);
  for (const double speed : world->dq()) EXPECT_LT(std::abs(speed), 0.01);
  EXPECT_EQ(host.state(), "Idle");
}

TEST_F(RobotService, HaltsAJogByItself) {
  call("jog", kSideways);
  run(0.2);
  robot->halt();
  EXPECT_EQ(host.state(), "Idle");
  run(0.2);
  for (const double speed : world->dq()) EXPECT_LT(std::abs(speed), 0.01);
}

TEST_F(RobotService, RefusesAWrongVelocityWhereverItIsAndGoesOn) {
  EXPECT_EQ(host.code(call("jog", R"({"linear": [0, 0.3, 0]})")), "out_of_range");
  EXPECT_EQ(host.state(), "Idle");
  call("jog", kSideways);
  run(0.2);
  const CallId wrong = call("jog", R"({"linear": [0, 0.3, 0]})");
  EXPECT_EQ(host.code(wrong), "out_of_range");
  ASSERT_TRUE(host.errors.contains(wrong));
  EXPECT_EQ(host.errors[wrong].find("argument")->as_string(), "linear");
  EXPECT_EQ(host.state(), "Jogging");
  run(0.2);
  EXPECT_EQ(host.state(), "Idle") << "it holds nothing up";
}

TEST_F(RobotService, DoesNotJogWhileItIsLedByHand) {
  call("change_behavior", R"(["gravity_compensation"])");
  EXPECT_EQ(host.code(call("jog", kSideways)), "behavior");
  EXPECT_EQ(host.state(), "Idle");
}

TEST_F(RobotService, RefusesToJogAfterACollisionUntilThePersonHasLetGo) {
  const auto push = [this] {
    for (int i = 0; i < 20; ++i) {
      world->push("gripper", {0, -60, 0}, world->pose("tcp").position);
      run(0.001);
    }
  };
  for (int i = 0; i < 10; ++i) {
    call("jog", kSideways);
    run(0.05);
  }
  for (int i = 0; i < 10 && host.counts["collision"] == 0; ++i) push();
  ASSERT_EQ(host.counts["collision"], 1);
  EXPECT_EQ(host.state(), "Idle");
  for (int i = 0; i < 20; ++i) {
    const CallId id = call("jog", kSideways);
    ASSERT_EQ(host.code(id), "collision") << "the button is still held";
    EXPECT_EQ(host.errors[id].find("reaction")->as_string(), "stop");
    EXPECT_EQ(host.state(), "Idle");
    run(0.05);
  }
  run(0.25);
  EXPECT_EQ(host.code(call("jog", kSideways)), "");
  EXPECT_EQ(host.state(), "Jogging");
}

TEST_F(RobotService, KeepsALimitOfTheToolsSpeed) {
  robot->limit_speed(0.1);
  double fastest = 0;
  const auto watch = [&] {
    const Vec3 before = world->pose("tcp").position;
    run(0.001);
    fastest = std::max(fastest, distance(world->pose("tcp").position, before) / 0.001);
  };
  const CallId slow = call("move", kDownPose);
  while (!host.answered(slow)) watch();
  EXPECT_EQ(host.code(slow), "");
  EXPECT_LE(fastest, 0.1);
  EXPECT_GT(fastest, 0.09);
  robot->limit_speed({});
  const CallId fast = call("move", R"([{"offset": [0, -0.2, 0.1]}])");
  while (!host.answered(fast)) watch();
  EXPECT_GT(fastest, 0.15);
}

}  // namespace
}  // namespace race::robot
