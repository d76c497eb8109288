// The result says whether a command has executed; one that timed out before it began never executes.
#include "server/cell/pending_commands.h"

#include <gmock/gmock.h>

#include <thread>
#include <vector>

namespace race::server {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

// Answers that never come are given up at once, all else is waited for.
constexpr PendingCommands::Timeouts kNone{0ms, 0ms}, kLong{60s, 60s};

struct PendingCommandsTest : testing::Test {
  using Start = std::function<void(CellWorld::Wanted, CellWorld::Done)>;
  Expected<Value> execute(PendingCommands& commands, const Start& start) {
    return wait_for<Value>([&](Done<Value> done) { commands.start(start, deadlines, std::move(done)); });
  }
  std::string why(PendingCommands& commands, const Start& start) {
    const auto answer = execute(commands, start);
    return answer ? "done" : to_string(answer.error());
  }
  Deadlines deadlines;
};

TEST_F(PendingCommandsTest, AResultReachesItsCaller) {
  PendingCommands commands(kLong);
  std::thread cell;
  const auto answer = execute(commands, [&](const auto& wanted, const auto& done) {
    cell = std::thread([wanted, done] {
      if (wanted()) done(Value(7));
    });
  });
  cell.join();
  EXPECT_EQ(answer.value(), Value(7));
}

TEST_F(PendingCommandsTest, ATimedOutCommandNeverExecutes) {
  PendingCommands commands(kNone);
  CellWorld::Wanted late;
  EXPECT_THAT(why(commands, [&](const auto& wanted, const auto&) { late = wanted; }),
              HasSubstr("unavailable: the cell does not answer; this is not done"));
  EXPECT_FALSE(late());
}

TEST_F(PendingCommandsTest, ACommandThatHasBegunMayExecute) {
  PendingCommands commands({50ms, 0ms});
  CellWorld::Done late;
  EXPECT_THAT(why(commands,
                  [&](const auto& wanted, const auto& done) {
                    EXPECT_TRUE(wanted());
                    late = done;
                  }),
              HasSubstr("it may be done"));
  late(Value(7));  // nobody waits any more
}

TEST_F(PendingCommandsTest, RefusesMoreThanTheMaximum) {
  PendingCommands commands(kLong);
  std::vector<CellWorld::Done> begun(PendingCommands::kMaxPending);
  int answered = 0;
  for (CellWorld::Done& each : begun)
    commands.start([&](const auto&, const auto& done) { each = done; }, deadlines,
                   [&](const Expected<Value>&) { ++answered; });
  const auto one = [&](const auto&, const auto& done) { done(Value(1)); };
  EXPECT_THAT(why(commands, one), HasSubstr("unavailable: other commands wait"));
  for (const CellWorld::Done& done : begun) done(Value());
  EXPECT_EQ(answered, PendingCommands::kMaxPending);
  EXPECT_EQ(why(commands, one), "done");
}

TEST_F(PendingCommandsTest, ACommandThatTheCellDropsIsPendingNoMore) {
  PendingCommands commands(kLong);
  for (int i = 0; i < 2 * PendingCommands::kMaxPending; ++i)
    EXPECT_THAT(why(commands, [](const auto&, const auto&) {}), HasSubstr("the server ends"));
}

}  // namespace
}  // namespace race::server
