// The result says whether a command has executed; one that timed out before it began never executes.
#include "server/cell/pending_commands.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>
#include <vector>

namespace race::server {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

// Places and answers that never come are given up at once, all else is waited for.
constexpr PendingCommands::Timeouts kNone{0ms, 0ms, 0ms}, kLong{0ms, 60s, 60s};

std::string why(const Expected<Value>& answer) { return answer ? "done" : to_string(answer.error()); }

TEST(PendingCommands, AResultReachesItsCaller) {
  PendingCommands commands(kLong);
  std::thread cell;
  const auto answer = commands.wait([&](const auto& wanted, const auto& done) {
    cell = std::thread([wanted, done] {
      if (wanted()) done(Value(7));
    });
  });
  cell.join();
  EXPECT_EQ(answer.value(), Value(7));
}

TEST(PendingCommands, ATimedOutCommandNeverExecutes) {
  PendingCommands commands(kNone);
  CellWorld::Wanted late;
  const auto answer = commands.wait([&](const auto& wanted, const auto&) { late = wanted; });
  EXPECT_THAT(why(answer), HasSubstr("unavailable: the cell does not answer; this is not done"));
  EXPECT_FALSE(late());
}

TEST(PendingCommands, ACommandThatHasBegunMayExecute) {
  PendingCommands commands(kNone);
  CellWorld::Done late;
  const auto answer = commands.wait([&](const auto& wanted, const auto& done) {
    EXPECT_TRUE(wanted());
    late = done;
  });
  EXPECT_THAT(why(answer), HasSubstr("it may be done"));
  late(Value(7));  // nobody waits any more
}

TEST(PendingCommands, RefusesMoreThanTheMaximum) {
  PendingCommands commands(kLong);
  std::vector<CellWorld::Done> begun(PendingCommands::kMaxPending);
  std::vector<std::thread> waiting;
  std::atomic<int> started = 0;
  for (CellWorld::Done& each : begun)
    waiting.emplace_back([&] {
      (void)commands.wait([&](const auto&, const auto& done) {
        each = done;
        ++started;
        started.notify_all();
      });
    });
  for (int count = started; count < PendingCommands::kMaxPending; count = started) started.wait(count);
  const auto one = [&](const auto&, const auto& done) { done(Value(1)); };
  EXPECT_THAT(why(commands.wait(one)), HasSubstr("unavailable: other commands wait"));
  for (const CellWorld::Done& done : begun) done(Value());
  for (std::thread& each : waiting) each.join();
  EXPECT_TRUE(commands.wait(one));
}

}  // namespace
}  // namespace race::server
