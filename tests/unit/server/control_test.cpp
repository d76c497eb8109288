#include "server/control/control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "core/value/json.h"
#include "server/control/stop_mark.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

struct ControlTest : testing::Test {
  std::vector<std::string> told;
  Control control{[this](const Value& json) { told.push_back(to_json(json)); }};
  // The code that answers a motion of a run; empty: it moves.
  std::string refusal(const std::string& core, std::uint64_t fence, const std::string& service = "robot") {
    const auto refused = control.refuse({core, 1, fence}, service);
    return refused ? refused->find("code")->as_string() : "";
  }
};

TEST_F(ControlTest, ARunReservesAServiceUntilItIsOver) {
  const std::uint64_t fence = control.begin().value();
  EXPECT_EQ(refusal("1", fence), "");
  EXPECT_EQ(refusal("2", fence), "leased");
  EXPECT_EQ(refusal("2", fence, "gripper"), "") << "another service is free";
  EXPECT_EQ(refusal("1", fence, "gripper"), "leased");
  control.release("2", "robot");
  EXPECT_EQ(refusal("2", fence), "leased") << "only who has it gives it back";
  control.release("1", "robot");
  EXPECT_EQ(refusal("2", fence), "");
}

TEST_F(ControlTest, NothingMovesWhileItIsStopped) {
  const std::uint64_t fence = control.begin().value();
  control.stop({"alice", 5});
  EXPECT_EQ(refusal("1", fence), "stopped");
  EXPECT_EQ(refusal("1", fence + 1), "stopped");
  EXPECT_EQ(control.begin().error().code, ErrorCode::stopped);
}

TEST_F(ControlTest, TheResetMovesNothingThatWasUnderWay) {
  const std::uint64_t before = control.begin().value();
  control.stop({"alice", 5});
  control.reset();
  EXPECT_EQ(refusal("1", before), "stopped") << "its number is old";
  EXPECT_EQ(refusal("1", control.begin().value()), "") << "a person has begun it anew";
}

TEST_F(ControlTest, EachStopEndsTheNumbersOfBefore) {
  control.stop({"alice", 5});
  control.reset();
  const std::uint64_t first = control.begin().value();
  control.stop({"bob", 6});
  control.stop({"carol", 7});
  EXPECT_EQ(control.stopped()->by, "bob") << "the first is told";
  control.reset();
  EXPECT_EQ(refusal("1", first), "stopped");
}

TEST_F(ControlTest, ARunThatNobodyHasBegunSinceTheStartMovesNothing) { EXPECT_EQ(refusal("1", 0), "stopped"); }

TEST_F(ControlTest, TellsWhatChangesAndNothingElse) {
  control.set_stop_port(8080, 8081);
  const std::uint64_t fence = control.begin().value();
  refusal("1", fence);
  refusal("1", fence);
  refusal("2", fence);
  control.stop({"alice", 5});
  control.stop({"alice", 6});
  control.release("1", "robot");
  control.release("1", "robot");
  control.reset();
  control.reset();
  const std::string ports = R"("stop_ports":[{"port":8080,"stop_port":8081}]})";
  EXPECT_THAT(told, testing::ElementsAre(
                        R"({"stopped":null,"leases":[{"service":"robot","core":"1"}],)" + ports,
                        R"({"stopped":{"by":"alice","time":5},"leases":[{"service":"robot","core":"1"}],)" + ports,
                        R"({"stopped":{"by":"alice","time":5},"leases":[],)" + ports,
                        R"({"stopped":null,"leases":[],)" + ports));
}

// 8 runs on threads of their own: at no time two have the service. (Run under the thread sanitizer.)
TEST_F(ControlTest, OfManyRunsAtOnceOneHasAService) {
  const std::uint64_t fence = control.begin().value();
  std::atomic<int> holders{0}, most{0}, turns{0};
  std::vector<std::thread> runs;
  for (int run = 0; run < 8; ++run)
    runs.emplace_back([&, core = std::to_string(run)] {
      for (int attempt = 0; attempt < 2000; ++attempt) {
        if (control.refuse({core, 1, fence}, "robot")) continue;
        const int now = ++holders;
        if (now > most) most = now;
        ++turns;
        --holders;
        control.release(core, "robot");
      }
    });
  for (std::thread& run : runs) run.join();
  EXPECT_EQ(most, 1);
  EXPECT_GT(turns, 0);
}

TEST(StopMark, OutlivesTheServerAndIsGoneAfterTheReset) {
  const TemporaryFolder place;
  const StopMark mark(place.file("stopped"));
  EXPECT_FALSE(mark.read());
  ASSERT_TRUE(mark.write(Control::Stop{"alice", 5}));
  EXPECT_EQ(mark.read()->by, "alice");
  EXPECT_EQ(mark.read()->time, 5);
  ASSERT_TRUE(mark.write(std::nullopt));
  EXPECT_FALSE(mark.read());
  ASSERT_TRUE(mark.write(std::nullopt));
}

TEST(StopMark, WhatCannotBeReadIsAStop) {
  const TemporaryFolder place;
  for (const char* text : {"", "{", "[]", R"({"by": 3, "time": "x"})"}) {
    std::ofstream(place.file("stopped")) << text;
    EXPECT_TRUE(StopMark(place.file("stopped")).read()) << text;
  }
}

}  // namespace
}  // namespace race::server
