// Who waits for an act is told the truth: what is not done now is not done later.
#include "server/cell/waiting_acts.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>
#include <vector>

namespace race::server {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

// Places and answers that never come are given up at once, all else is waited for.
constexpr WaitingActs::Patience kNone{0ms, 0ms, 0ms}, kLong{0ms, 60s, 60s};

std::string why(const Expected<Value>& answer) { return answer ? "done" : to_string(answer.error()); }

TEST(WaitingActs, AnAnswerReachesWhoWaits) {
  WaitingActs acts(kLong);
  std::thread cell;
  const auto answer = acts.wait([&](const auto& wanted, const auto& done) {
    cell = std::thread([wanted, done] {
      if (wanted()) done(Value(7));
    });
  });
  cell.join();
  EXPECT_EQ(answer.value(), Value(7));
}

TEST(WaitingActs, WhatIsGivenUpIsNotDoneLater) {
  WaitingActs acts(kNone);
  CellWorld::Wanted late;
  const auto answer = acts.wait([&](const auto& wanted, const auto&) { late = wanted; });
  EXPECT_THAT(why(answer), HasSubstr("unavailable: the cell does not answer; this is not done"));
  EXPECT_FALSE(late());
}

TEST(WaitingActs, WhatHasBegunMayBeDone) {
  WaitingActs acts(kNone);
  CellWorld::Done late;
  const auto answer = acts.wait([&](const auto& wanted, const auto& done) {
    EXPECT_TRUE(wanted());
    late = done;
  });
  EXPECT_THAT(why(answer), HasSubstr("it may be done"));
  late(Value(7));  // to nobody
}

TEST(WaitingActs, AFewWaitAndTheOthersAreRefused) {
  WaitingActs acts(kLong);
  std::vector<CellWorld::Done> begun(WaitingActs::kPlaces);
  std::vector<std::thread> waiting;
  std::atomic<int> started = 0;
  for (CellWorld::Done& each : begun)
    waiting.emplace_back([&] {
      (void)acts.wait([&](const auto&, const auto& done) {
        each = done;
        ++started;
        started.notify_all();
      });
    });
  for (int count = started; count < WaitingActs::kPlaces; count = started) started.wait(count);
  const auto one = [&](const auto&, const auto& done) { done(Value(1)); };
  EXPECT_THAT(why(acts.wait(one)), HasSubstr("unavailable: other acts wait"));
  for (const CellWorld::Done& done : begun) done(Value());
  for (std::thread& each : waiting) each.join();
  EXPECT_TRUE(acts.wait(one));
}

}  // namespace
}  // namespace race::server
