// What passes on data flows: their rates, and when they have stopped.
#include "services/host/flow_traffic.h"

#include <gmock/gmock.h>

namespace race::services {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct FlowTrafficTest : testing::Test {
  bool pass(Time now, const char* key = "tap", const char* flow = "water") {
    return traffic.record(key, flow, Packet{now - 0.5, "drop", {}}, now);
  }
  FlowTraffic traffic;
};

TEST_F(FlowTrafficTest, OneThatNothingPassesHasNoRate) {
  EXPECT_EQ(traffic.read("tap", "water", 1.0).rate_hz, 0);
  EXPECT_FALSE(traffic.read("tap", "water", 1.0).last);
  pass(1.0);
  EXPECT_EQ(traffic.read("tap", "water", 1.0).rate_hz, 0) << "one packet has no period";
  EXPECT_EQ(traffic.read("tap", "water", 1.0).last->time, 0.5);
}

TEST_F(FlowTrafficTest, TheRateIsOfTheLastPackets) {
  for (int i = 0; i < 30; ++i) pass(i);
  for (int i = 0; i < 10; ++i) pass(30 + 0.1 * i);
  EXPECT_NEAR(traffic.read("tap", "water", 31.0).rate_hz, 10.0, 1e-6);
}

TEST_F(FlowTrafficTest, IsReportedAtFirstThenOnceASecond) {
  EXPECT_TRUE(pass(0.0));
  EXPECT_TRUE(pass(0.1));
  EXPECT_FALSE(pass(0.2));
  EXPECT_FALSE(pass(1.0));
  EXPECT_TRUE(pass(1.2));
}

TEST_F(FlowTrafficTest, OneThatIsSilentForLongHasStoppedOnce) {
  pass(0.0);
  pass(1.0);
  EXPECT_THAT(traffic.stopped(4.9), IsEmpty());
  EXPECT_EQ(traffic.read("tap", "water", 5.1).rate_hz, 0);
  EXPECT_THAT(traffic.stopped(5.1), ElementsAre("tap"));
  EXPECT_THAT(traffic.stopped(5.2), IsEmpty());
}

TEST_F(FlowTrafficTest, AResetForgetsOneFlowOrAllOfAService) {
  pass(0.0);
  pass(0.0, "tap", "steam");
  pass(0.0, "well");
  traffic.reset("tap", "water");
  EXPECT_FALSE(traffic.read("tap", "water", 0.0).last);
  EXPECT_TRUE(traffic.read("tap", "steam", 0.0).last);
  traffic.reset("tap");
  EXPECT_FALSE(traffic.read("tap", "steam", 0.0).last);
  EXPECT_TRUE(traffic.read("well", "water", 0.0).last);
}

}  // namespace
}  // namespace race::services
