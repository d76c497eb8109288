// A behavior as tasks write it: what is read, what is refused and why.
#include <gtest/gtest.h>

#include <random>

#include "core/rsm/type.h"
#include "core/value/json.h"
#include "services/robot/behavior_value.h"
#include "services/robot/robot.h"

namespace race::robot {
namespace {

tl::expected<Behavior, Refusal> read(std::string_view json) { return read_behavior(parse_json(json).value()); }

TEST(Behavior, IsReadFieldByField) {
  const auto behavior = read(R"({
    "operational": {"mode": "cartesian_impedance", "stiffness": [100, 200, 300, 10, 20, 30], "damping": 0.7,
                    "limits": {"speed": 0.25, "force": 40}},
    "reflexes": [{"signal": "collision", "reaction": "slow_down", "scale": 0.1},
                 {"signal": "collision", "severity": "severe", "reaction": "gravity_compensation"},
                 {"signal": "virtual_wall", "wall": {"point": [0, 0, 0.1], "normal": [0, 0, 2]}, "reaction": "stop"},
                 {"signal": "virtual_wall", "wall": {"min": [0, 0, 0], "max": [1, 1, 1]}, "reaction": "stop"},
                 {"signal": "force_limit", "force": 30, "reaction": "retreat", "distance": 0.02}]})");
  ASSERT_TRUE(behavior) << behavior.error().message;
  EXPECT_EQ(behavior->operational.mode, Mode::cartesian_impedance);
  EXPECT_EQ(behavior->operational.tool_stiffness[2], 300);
  EXPECT_EQ(behavior->operational.damping, 0.7);
  EXPECT_EQ(behavior->operational.speed, 0.25);
  EXPECT_EQ(behavior->operational.force, 40);
  ASSERT_EQ(behavior->reflexes.size(), 5U);
  EXPECT_EQ(behavior->reflexes[0].scale, 0.1);
  EXPECT_EQ(behavior->reflexes[1].severity, Severity::severe);
  EXPECT_EQ(std::get<Plane>(behavior->reflexes[2].wall).normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(behavior->reflexes[4].distance, 0.02);
}

TEST(Behavior, HasSafeReflexesUnlessItNamesItsOwn) {
  for (const char* mode : {"position", "joint_impedance", "cartesian_impedance"}) {
    const auto behavior = read(R"({"operational": {"mode": ")" + std::string(mode) + "\"}}");
    ASSERT_EQ(behavior->reflexes.size(), 1U) << mode;
    EXPECT_EQ(behavior->reflexes[0].signal, Signal::collision);
    EXPECT_EQ(behavior->reflexes[0].reaction, Reaction::stop);
  }
  EXPECT_TRUE(read(R"({"operational": {"mode": "gravity_compensation"}})")->reflexes.empty());
  EXPECT_TRUE(read(R"({"operational": {"mode": "position"}, "reflexes": []})")->reflexes.empty());
}

TEST(Behavior, MayBeTheNameOfAMode) {
  EXPECT_EQ(read("\"joint_impedance\"")->operational.mode, Mode::joint_impedance);
  EXPECT_EQ(read("\"dance\"").error().code, "type");
}

TEST(Behavior, IsOfTheTypeThatTheServiceDeclares) {
  const rsm::Service& service = model();
  EXPECT_EQ(service.operations[0].parameters[1].type, Value(Dict{{"optional", parse_json(kBehaviorType).value()}}));
}

struct Wrong {
  const char* name;
  const char* json;
  const char* code;
  const char* says;
};

class WrongBehavior : public testing::TestWithParam<Wrong> {};

TEST_P(WrongBehavior, IsRefusedWithTheReason) {
  const auto behavior = read(GetParam().json);
  ASSERT_FALSE(behavior);
  EXPECT_EQ(behavior.error().code, GetParam().code) << behavior.error().message;
  EXPECT_EQ(behavior.error().argument, "behavior");
  EXPECT_NE(behavior.error().message.find(GetParam().says), std::string::npos) << behavior.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    Behavior, WrongBehavior,
    testing::Values(
        Wrong{"Number", "17", "type", "behavior"}, Wrong{"NoMode", R"({"operational": {}})", "type", "mode"},
        Wrong{"UnknownField", R"({"operational": {"mode": "position"}, "reflex": []})", "type", "reflex"},
        Wrong{"NegativeStiffness",
              R"({"operational": {"mode": "joint_impedance", "stiffness": [100, 100, -1, 100, 100, 50, 50]}})",
              "out_of_range", "stiffness"},
        Wrong{"TooStiff", R"({"operational": {"mode": "cartesian_impedance", "stiffness": [1e5, 1, 1, 1, 1, 1]}})",
              "out_of_range", "stiffness"},
        Wrong{"SixStiffnessesOfSevenJoints",
              R"({"operational": {"mode": "joint_impedance", "stiffness": [1, 1, 1, 1, 1, 1]}})", "type", "7"},
        Wrong{"StiffnessInPosition", R"({"operational": {"mode": "position", "stiffness": [1, 1, 1, 1, 1, 1]}})",
              "type", "stiffness"},
        Wrong{"NoDamping", R"({"operational": {"mode": "joint_impedance", "damping": 0}})", "out_of_range", "damping"},
        Wrong{"NoSpeed", R"({"operational": {"mode": "position", "limits": {"speed": 0}}})", "out_of_range", "speed"},
        Wrong{"ForceLimitInPosition", R"({"operational": {"mode": "position", "limits": {"force": 10}}})", "type",
              "force"},
        Wrong{"UnknownSignal",
              R"({"operational": {"mode": "position"}, "reflexes": [{"signal": "smell", "reaction": "stop"}]})", "type",
              "signal"},
        Wrong{"ForceWithoutLimit",
              R"({"operational": {"mode": "position"}, "reflexes": [{"signal": "force_limit", "reaction": "stop"}]})",
              "missing", "force"},
        Wrong{"NegativeForce",
              R"({"operational": {"mode": "position"},
                  "reflexes": [{"signal": "force_limit", "force": -5, "reaction": "stop"}]})",
              "out_of_range", "force"},
        Wrong{"WallWithoutDirection",
              R"({"operational": {"mode": "position"}, "reflexes": [
                  {"signal": "virtual_wall", "wall": {"point": [0, 0, 0], "normal": [0, 0, 0]}, "reaction": "stop"}]})",
              "out_of_range", "normal"},
        Wrong{"BoxInsideOut",
              R"({"operational": {"mode": "position"}, "reflexes": [
                  {"signal": "virtual_wall", "wall": {"min": [0, 0, 1], "max": [1, 1, 0]}, "reaction": "stop"}]})",
              "out_of_range", "wall"},
        Wrong{"HalfAPlane",
              R"({"operational": {"mode": "position"}, "reflexes": [
                  {"signal": "virtual_wall", "wall": {"point": [0, 0, 1]}, "reaction": "stop"}]})",
              "type", "wall"},
        Wrong{"SeverityOfAWall",
              R"({"operational": {"mode": "position"}, "reflexes": [
                  {"signal": "joint_limit", "severity": "light", "reaction": "stop"}]})",
              "type", "severity"},
        Wrong{"DistanceOfAStop",
              R"({"operational": {"mode": "position"}, "reflexes": [
                  {"signal": "contact", "distance": 0.1, "reaction": "stop"}]})",
              "type", "distance"},
        Wrong{"TwoReactions",
              R"({"operational": {"mode": "position"}, "reflexes": [
                  {"signal": "contact", "reaction": "stop"}, {"signal": "contact", "reaction": "retreat"}]})",
              "duplicate", "contact"}),
    [](const auto& info) { return info.param.name; });

TEST(Behavior, AnyValueIsReadOrRefusedAndWhatIsReadIsFinite) {
  constexpr unsigned seed = 2013;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const auto number = [&]() -> Value {
    const std::vector<Value> odd = {0, -1, 1e300, NAN, INFINITY, -INFINITY, "x", Value(), true};
    if (random() % 6 == 0) return odd[random() % odd.size()];
    return std::uniform_real_distribution(0.0, 2.0)(random);
  };
  const auto list = [&](std::size_t size) {
    List items;
    for (std::size_t i = 0; i < size; ++i) items.push_back(number());
    return Value(items);
  };
  const std::array modes = {"position", "joint_impedance", "cartesian_impedance", "gravity_compensation", "none"};
  const std::array signals = {"contact", "collision", "force_limit", "virtual_wall", "joint_limit"};
  const std::array reactions = {"stop", "gravity_compensation", "retreat", "slow_down"};
  int accepted = 0;
  for (int i = 0; i < 3000; ++i) {
    Dict operational{{"mode", modes[random() % 5]}};
    if (random() % 3 == 0) operational.set("stiffness", list(6 + random() % 2));
    if (random() % 4 == 0) operational.set("damping", number());
    if (random() % 4 == 0) operational.set("limits", Dict{{"speed", number()}});
    List reflexes;
    for (std::size_t k = random() % 3; k > 0; --k) {
      Dict reflex{{"signal", signals[random() % 5]}, {"reaction", reactions[random() % 4]}};
      if (random() % 3 == 0) reflex.set("force", number());
      if (random() % 3 == 0) reflex.set("wall", Dict{{"point", list(3)}, {"normal", list(3)}});
      if (random() % 4 == 0) reflex.set("distance", number());
      reflexes.emplace_back(reflex);
    }
    const auto behavior = read_behavior(Dict{{"operational", operational}, {"reflexes", reflexes}});
    if (!behavior) {
      ASSERT_EQ(behavior.error().argument, "behavior") << "case " << i;
      continue;
    }
    ++accepted;
    for (const double k : behavior->operational.joint_stiffness) ASSERT_TRUE(k >= 0 && k <= 1000) << "case " << i;
    for (const double k : behavior->operational.tool_stiffness) ASSERT_TRUE(k >= 0 && k <= 3000) << "case " << i;
    ASSERT_TRUE(behavior->operational.damping > 0) << "case " << i;
    for (const Reflex& reflex : behavior->reflexes) {
      ASSERT_TRUE(std::isfinite(depth(reflex.wall, {0.1, 0.2, 0.3})) || reflex.signal != Signal::virtual_wall);
      ASSERT_TRUE(reflex.signal != Signal::force_limit || reflex.force > 0) << "case " << i;
    }
  }
  EXPECT_GT(accepted, 200);
  EXPECT_LT(accepted, 2800);
}

}  // namespace
}  // namespace race::robot
