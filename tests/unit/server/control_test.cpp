#include "server/control/control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "core/value/json.h"
#include "server/control/mode_mark.h"
#include "server/control/stop_mark.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

struct ControlTest : testing::Test {
  std::vector<std::string> told;
  bool has_accounts = false;
  Control control{[this](const Value& json) { told.push_back(to_json(json)); }, [this] { return has_accounts; }};
  // The code that answers a motion of a run; empty: it moves.
  std::string refusal(const std::string& core, std::uint64_t fence, const std::string& service = "robot",
                      rsm::CallEffect effect = rsm::CallEffect::motion) {
    const auto refused = control.refuse({core, 1, fence}, service, effect);
    return refused ? refused->find("code")->as_string() : "";
  }
};

TEST_F(ControlTest, ARunReservesAServiceUntilItIsOver) {
  const std::uint64_t fence = control.begin({"1"}).value();
  EXPECT_EQ(refusal("1", fence), "");
  EXPECT_EQ(refusal("2", fence), "leased");
  EXPECT_EQ(refusal("2", fence, "gripper"), "") << "another service is free";
  EXPECT_EQ(refusal("1", fence, "gripper"), "leased");
  control.release("2", "robot");
  EXPECT_EQ(refusal("2", fence), "leased") << "only who has it gives it back";
  control.release("1", "robot");
  EXPECT_EQ(refusal("2", fence), "");
}

TEST_F(ControlTest, WhatWasCalledByHandBeforeAServiceWasStoppedMovesNothing) {
  const std::uint64_t alice = control.take("alice", Control::Steady()).value();
  ASSERT_TRUE(control.set_mode(alice, Mode::programming));
  const std::uint64_t fence = control.fence_of(alice).value();
  const auto code = [&](std::uint64_t call, const char* service = "robot") {
    const auto refused = control.refuse({Control::caller(alice), call, fence}, service, rsm::CallEffect::motion);
    return refused ? refused->find("code")->as_string() : "";
  };
  control.end_by_hand("robot", 7);
  control.end_by_hand("robot", 5);
  EXPECT_EQ(code(7), "stopped");
  EXPECT_EQ(code(8), "");
  EXPECT_EQ(code(7, "gripper"), "") << "another service";
}

TEST_F(ControlTest, NothingMovesWhileItIsStopped) {
  const std::uint64_t fence = control.begin({"1"}).value();
  control.stop({"alice", 5});
  EXPECT_EQ(refusal("1", fence), "stopped");
  EXPECT_EQ(refusal("1", fence + 1), "stopped");
  EXPECT_EQ(control.begin({"1"}).error().code, ErrorCode::stopped);
}

TEST_F(ControlTest, TheResetMovesNothingThatWasUnderWay) {
  const std::uint64_t before = control.begin({"1"}).value();
  control.stop({"alice", 5});
  control.reset();
  EXPECT_EQ(refusal("1", before), "stopped") << "its number is old";
  EXPECT_EQ(refusal("1", control.begin({"1"}).value()), "") << "a person has begun it anew";
}

TEST_F(ControlTest, EachStopEndsTheNumbersOfBefore) {
  control.stop({"alice", 5});
  control.reset();
  const std::uint64_t first = control.begin({"1"}).value();
  control.stop({"bob", 6});
  control.stop({"carol", 7});
  EXPECT_EQ(control.stopped()->by, "bob") << "the first is told";
  control.reset();
  EXPECT_EQ(refusal("1", first), "stopped");
}

TEST_F(ControlTest, ARunThatNobodyHasBegunSinceTheStartMovesNothing) { EXPECT_EQ(refusal("1", 0), "stopped"); }

struct ControlsTest : ControlTest {
  Control::Steady now = std::chrono::steady_clock::now();
  std::uint64_t take(const char* by = "alice") { return control.take(by, now).value(); }
  std::string by_hand(std::uint64_t number, const std::string& service = "robot") {
    const auto fence = control.fence_of(number);
    return fence ? refusal(Control::caller(number), *fence, service) : std::string(name(fence.error().code));
  }
  ErrorCode begin_error(const services::Beginning& run) { return control.begin(run).error().code; }
};

TEST_F(ControlsTest, OnePersonAtATimeHasThem) {
  const std::uint64_t alice = take();
  EXPECT_EQ(control.take("bob", now).error().code, ErrorCode::leased);
  EXPECT_FALSE(control.release(alice + 1)) << "nobody else gives them back";
  ASSERT_TRUE(control.release(alice));
  EXPECT_FALSE(control.release(alice));
  EXPECT_NE(take("bob"), alice);
}

TEST_F(ControlsTest, WhoIsSilentLosesThem) {
  const std::uint64_t alice = take();
  now += Control::kSilence;
  EXPECT_FALSE(control.release_silent(now));
  EXPECT_TRUE(control.hear(alice, now));
  now += Control::kSilence;
  EXPECT_FALSE(control.release_silent(now)) << "heard since";
  now += std::chrono::milliseconds(1);
  EXPECT_EQ(control.release_silent(now)->by, "alice");
  EXPECT_FALSE(control.hear(alice, now));
  EXPECT_FALSE(control.release_silent(now));
}

TEST_F(ControlsTest, OnlyWhoHasThemMovesByHandAndOnlyInProgrammingMode) {
  const std::uint64_t alice = take();
  EXPECT_EQ(by_hand(alice), "not_accepted") << "in execution mode";
  ASSERT_TRUE(control.set_mode(alice, Mode::programming));
  EXPECT_EQ(by_hand(alice), "");
  EXPECT_EQ(by_hand(alice + 1), "leased");
  const std::uint64_t fence = control.fence_of(alice).value();
  control.release(alice);
  EXPECT_EQ(refusal(Control::caller(alice), fence), "stopped") << "what was on its way";
  const std::uint64_t bob = take("bob");
  EXPECT_EQ(refusal(Control::caller(alice), fence), "stopped") << "of who had them before";
  EXPECT_EQ(by_hand(bob), "");
}

TEST_F(ControlsTest, HowFastARunMovesIsSetInEitherModeAndTheMotionStaysThatOfTheRun) {
  using enum rsm::CallEffect;
  const std::uint64_t run = control.begin({"1"}).value();
  ASSERT_EQ(refusal("1", run), "");
  const std::uint64_t alice = take(), fence = control.fence_of(alice).value();
  EXPECT_EQ(refusal(Control::caller(alice), fence, "robot", pace), "");
  EXPECT_EQ(refusal("2", run, "robot", pace), "leased") << "no other run sets it";
  EXPECT_EQ(refusal("1", run), "") << "it has the robot as before";
  EXPECT_TRUE(control.release(alice)->services.empty()) << "it goes on without them";
  EXPECT_EQ(refusal(Control::caller(alice), fence, "robot", pace), "stopped") << "what was on its way";
  const std::uint64_t bob = take("bob"), his = control.fence_of(bob).value();
  control.stop({"carol", 7});
  EXPECT_EQ(refusal(Control::caller(bob), his, "robot", pace), "stopped");
}

TEST_F(ControlsTest, WhatTheyHaveMovedStopsWithThem) {
  const std::uint64_t alice = take();
  ASSERT_TRUE(control.set_mode(alice, Mode::programming));
  by_hand(alice, "gripper");
  refusal("1", control.begin({"1", alice}).value(), "robot");
  control.begin({"2", alice}).value();
  by_hand(alice, "gripper");
  const auto ended = control.release(alice);
  EXPECT_THAT(ended->services, testing::ElementsAre("gripper", "robot"));
  EXPECT_THAT(ended->cores, testing::ElementsAre("1", "2")) << "also a run that has moved nothing yet";
}

TEST_F(ControlsTest, AMotionStopsWithThemThoughItsReservationHasEnded) {
  const std::uint64_t alice = take();
  ASSERT_TRUE(control.set_mode(alice, Mode::programming));
  const std::uint64_t fence = control.begin({"1", alice}).value();
  refusal("1", fence);
  control.release("1", "robot");  // the run is over, what it has begun is not
  by_hand(alice, "gripper");
  control.begin({"2", alice}).value();  // it moves nothing
  const auto ended = control.release(alice);
  EXPECT_THAT(ended->services, testing::ElementsAre("gripper", "robot"));
  EXPECT_THAT(ended->cores, testing::ElementsAre("2")) << "the first is over";
}

TEST_F(ControlsTest, AnotherModeStopsAMotionThoughItsReservationHasEnded) {
  refusal("1", control.begin({"1"}).value());
  control.release("1", "robot");
  EXPECT_THAT(control.set_mode(take(), Mode::programming)->services, testing::ElementsAre("robot"));
}

TEST_F(ControlsTest, WhatAnotherRunHasMovedSinceDoesNotStopWithThem) {
  const std::uint64_t alice = take();
  const std::uint64_t theirs = control.begin({"1", alice, true}).value();
  refusal("1", theirs);
  control.release("1", "robot");
  refusal("2", control.begin({"2", alice}).value());
  EXPECT_TRUE(control.release(alice)->services.empty());
}

TEST_F(ControlsTest, ARunThatNeedsThemNoMoreGoesOnWithoutThem) {
  const std::uint64_t alice = take();
  control.begin({"1", alice, true}).value();
  const std::uint64_t fence = control.begin({"1", alice, false}).value();
  EXPECT_TRUE(control.release(alice)->cores.empty());
  EXPECT_EQ(refusal("1", fence), "");
}

TEST_F(ControlsTest, ValuesOfARunAreForcedByWhoHasThemAlone) {
  const auto code = [&](const services::Beginning& run) {
    const auto may = control.may_force(run);
    return may ? std::string() : std::string(name(may.error().code));
  };
  refusal("1", control.begin({"1"}).value());
  EXPECT_EQ(code({"1"}), "") << "on this machine alone, nobody has them";
  EXPECT_EQ(code({"1", 0, true}), "conflict") << "it needs them";
  has_accounts = true;
  EXPECT_EQ(code({"1"}), "conflict") << "it moves something";
  EXPECT_EQ(code({"2"}), "");
  const std::uint64_t alice = take();
  EXPECT_EQ(code({"1", alice}), "");
  EXPECT_EQ(code({"2"}), "leased");
  ASSERT_TRUE(control.set_mode(alice, Mode::programming));
  control.release(alice);
  EXPECT_EQ(code({"2"}), "conflict") << "each run needs them";
}

TEST_F(ControlsTest, AnUnsupervisedRunGoesOnWithoutThem) {
  const std::uint64_t alice = take();
  const std::uint64_t fence = control.begin({"1", alice}).value();
  EXPECT_EQ(refusal("1", fence), "");
  const auto ended = control.release(alice);
  EXPECT_TRUE(ended->services.empty());
  EXPECT_EQ(refusal("1", fence), "");
}

TEST_F(ControlsTest, ASupervisedRunNeedsWhoBeganIt) {
  EXPECT_EQ(begin_error({"1", 0, true}), ErrorCode::conflict) << "nobody has the controls";
  const std::uint64_t alice = take();
  EXPECT_EQ(begin_error({"1", 0, true}), ErrorCode::leased);
  const std::uint64_t fence = control.begin({"1", alice, true}).value();
  EXPECT_EQ(refusal("1", fence), "");
  control.release(alice);
  EXPECT_EQ(refusal("1", fence), "stopped");
  const std::uint64_t bob = take("bob");
  EXPECT_EQ(refusal("1", fence), "stopped") << "nobody has let it go on";
  EXPECT_EQ(refusal("1", control.begin({"1", bob, true}).value()), "") << "its service is still its own";
}

TEST_F(ControlsTest, NobodyElseBeginsARun) {
  const std::uint64_t alice = take();
  EXPECT_EQ(begin_error({"1"}), ErrorCode::leased);
  EXPECT_EQ(begin_error({"1", alice + 1}), ErrorCode::leased);
  EXPECT_TRUE(control.begin({"1", alice}));
  control.release(alice);
  EXPECT_EQ(begin_error({"1", alice, true}), ErrorCode::conflict) << "the number is old";
  EXPECT_TRUE(control.begin({"1"}));
}

TEST_F(ControlsTest, InProgrammingModeEachRunNeedsThem) {
  const std::uint64_t alice = take();
  ASSERT_TRUE(control.set_mode(alice, Mode::programming));
  control.release(alice);
  EXPECT_EQ(begin_error({"1"}), ErrorCode::conflict);
  const std::uint64_t bob = take("bob");
  const std::uint64_t fence = control.begin({"1", bob}).value();
  control.release(bob);
  EXPECT_EQ(refusal("1", fence), "stopped");
}

TEST_F(ControlsTest, AnotherModeStopsAllThatMoves) {
  const std::uint64_t fence = control.begin({"1"}).value();
  refusal("1", fence);
  const std::uint64_t alice = take();
  EXPECT_EQ(control.set_mode(alice + 1, Mode::programming).error().code, ErrorCode::leased);
  const auto ended = control.set_mode(alice, Mode::programming);
  EXPECT_THAT(ended->services, testing::ElementsAre("robot"));
  EXPECT_THAT(ended->cores, testing::ElementsAre("1"));
  EXPECT_EQ(refusal("1", fence), "stopped");
  EXPECT_EQ(by_hand(alice), "") << "a run that moves nothing any more makes way";
  EXPECT_TRUE(control.set_mode(alice, Mode::programming)->services.empty()) << "nothing new";
}

TEST_F(ControlsTest, ARunReservesWhatItsBeginnerHasMovedByHand) {
  const std::uint64_t alice = take();
  ASSERT_TRUE(control.set_mode(alice, Mode::programming));
  by_hand(alice);
  const std::uint64_t fence = control.begin({"1", alice}).value();
  EXPECT_EQ(refusal("1", fence), "");
  EXPECT_EQ(by_hand(alice), "leased");
}

TEST_F(ControlsTest, AStopEndsWhatIsOnItsWayByHand) {
  const std::uint64_t alice = take();
  ASSERT_TRUE(control.set_mode(alice, Mode::programming));
  const std::uint64_t fence = control.fence_of(alice).value();
  control.stop({"bob", 5});
  EXPECT_EQ(by_hand(alice), "stopped");
  control.reset();
  EXPECT_EQ(refusal(Control::caller(alice), fence), "stopped");
  EXPECT_EQ(by_hand(alice), "");
}

TEST_F(ControlsTest, EditsOfWhatMovesAreConfirmedInExecutionMode) {
  refusal("1", control.begin({"1"}).value());
  EXPECT_FALSE(control.confirms_edits("1")) << "nobody has the controls of this machine's own demo";
  has_accounts = true;
  EXPECT_TRUE(control.confirms_edits("1"));
  has_accounts = false;
  const std::uint64_t alice = take();
  EXPECT_TRUE(control.confirms_edits("1"));
  EXPECT_FALSE(control.confirms_edits("2")) << "it moves nothing";
  ASSERT_TRUE(control.set_mode(alice, Mode::programming));
  EXPECT_FALSE(control.confirms_edits("1"));
}

// Threads take, are heard, move and give back: at no time two have them, and no call of another moves anything. (Run
// under the thread sanitizer.)
TEST_F(ControlsTest, OfManyAtOnceOneHasThem) {
  const std::uint64_t first = take();
  ASSERT_TRUE(control.set_mode(first, Mode::programming));
  control.release(first);
  std::atomic<std::uint64_t> holder{0};
  std::atomic<int> takings{0}, wrong{0};
  std::vector<std::thread> people;
  for (int person = 0; person < 8; ++person)
    people.emplace_back([&] {
      for (int attempt = 0; attempt < 2000; ++attempt) {
        const auto number = control.take("person", std::chrono::steady_clock::now());
        if (!number) {
          const std::uint64_t other = holder;
          if (other != 0 && !control.refuse({Control::caller(other + 1), 1, 0}, "robot", rsm::CallEffect::motion))
            ++wrong;
          continue;
        }
        if (holder.exchange(*number) != 0) ++wrong;
        ++takings;
        if (!by_hand(*number).empty()) ++wrong;
        holder = 0;
        if (!control.release(*number)) ++wrong;
      }
    });
  for (std::thread& person : people) person.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(takings, 0);
}

TEST_F(ControlTest, TellsWhatChangesAndNothingElse) {
  control.set_stop_port(8080, 8081);
  const std::uint64_t fence = control.begin({"1"}).value();
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
  EXPECT_THAT(
      told,
      testing::ElementsAre(
          R"({"stopped":null,"mode":"execution","holder":null,"request":null,"leases":[{"service":"robot","core":"1"}],)" +
              ports,
          R"({"stopped":{"by":"alice","time":5},"mode":"execution","holder":null,"request":null,"leases":[{"service":"robot","core":"1"}],)" +
              ports,
          R"({"stopped":{"by":"alice","time":5},"mode":"execution","holder":null,"request":null,"leases":[],)" + ports,
          R"({"stopped":null,"mode":"execution","holder":null,"request":null,"leases":[],)" + ports));
}

// 8 runs on threads of their own: at no time two have the service. (Run under the thread sanitizer.)
TEST_F(ControlTest, OfManyRunsAtOnceOneHasAService) {
  const std::uint64_t fence = control.begin({"1"}).value();
  std::atomic<int> holders{0}, most{0}, turns{0};
  std::vector<std::thread> runs;
  for (int run = 0; run < 8; ++run)
    runs.emplace_back([&, core = std::to_string(run)] {
      for (int attempt = 0; attempt < 2000; ++attempt) {
        if (control.refuse({core, 1, fence}, "robot", rsm::CallEffect::motion)) continue;
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

TEST(ModeMark, OutlivesTheServer) {
  const TemporaryFolder place;
  const ModeMark mark(place.file("mode"));
  EXPECT_EQ(mark.read(), Mode::execution) << "of a new server";
  ASSERT_TRUE(mark.write(Mode::programming));
  EXPECT_EQ(mark.read(), Mode::programming);
  ASSERT_TRUE(mark.write(Mode::execution));
  EXPECT_EQ(mark.read(), Mode::execution);
}

TEST(ModeMark, WhatCannotBeReadIsTheModeInWhichLessMoves) {
  const TemporaryFolder place;
  for (const char* text : {"", "execution ", "Execution", "{}"}) {
    std::ofstream(place.file("mode")) << text;
    EXPECT_EQ(ModeMark(place.file("mode")).read(), Mode::programming) << text;
  }
}

}  // namespace
}  // namespace race::server
