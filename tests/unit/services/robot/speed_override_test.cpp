// The speed override of the service `robot`: whom it outlives, and how a person learns why nothing moves.
#include "tests/unit/services/robot/robot_service.h"

namespace race::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct SpeedOverride : RobotService {
  double share() {
    const CallId id = call("state");
    return host.results[id].find("speed_override")->to_double();
  }
  double published() const { return host.packets.at("control").back()->header.find("speed_override")->to_double(); }
  CallId move() { return call("move", R"({"target": {"offset": [0, 0, 0.05]}})"); }
};

TEST_F(SpeedOverride, OutlivesAStopAHaltAndAnotherMode) {
  call("speed_override", "[0.5]");
  call("stop");
  EXPECT_EQ(share(), 0.5);
  robot->halt();
  EXPECT_EQ(share(), 0.5);
  robot->limit_speed(0.25);
  EXPECT_EQ(share(), 0.5);
  robot->limit_speed(std::nullopt);
  EXPECT_EQ(share(), 0.5) << "nothing is faster than before";
  call("speed_override", "[0]");
  const CallId id = move();
  run(1);
  call("stop");
  EXPECT_EQ(host.code(id), "stopped");
  const CallId next = move();
  run(2);
  EXPECT_FALSE(host.answered(next));
  call("speed_override", "[1]");
  finish(next);
  EXPECT_EQ(host.code(next), "");
}

TEST_F(SpeedOverride, IsPublishedWithHowTheArmIsControlled) {
  robot->demand_changed("control", true);
  run(0.2);
  EXPECT_EQ(published(), 1);
  call("speed_override", "[0]");
  run(0.2);
  EXPECT_EQ(published(), 0);
  call("stop");
  run(0.2);
  EXPECT_EQ(published(), 0);
}

TEST_F(SpeedOverride, OfZeroIsSaidInTheLogWhenAMotionBegins) {
  finish(move());
  call("speed_override", "[0.05]");
  finish(call("move", R"({"target": {"offset": [0, 0, -0.001]}})"));
  call("speed_override", "[0]");
  EXPECT_THAT(host.logged, IsEmpty()) << "who has set it knows it";
  EXPECT_EQ(host.code(call("move", R"({"target": {"offset": [0, 0, 9]}})")), "path");
  EXPECT_THAT(host.logged, IsEmpty()) << "no motion has begun";
  move();
  EXPECT_THAT(host.logged, ElementsAre(HasSubstr("`speed_override` is 0")));
  call("stop");
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(host.code(call("jog", R"({"linear": [0, 0.1, 0]})")), "");
    run(0.1);
  }
  EXPECT_EQ(host.logged.size(), 2U) << "once, while the button is held";
}

}  // namespace
}  // namespace race::robot
