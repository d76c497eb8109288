// Work that is due after a time, and where values of what was asked go.
#include "server/threads/deadlines.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <vector>

#include "server/threads/done.h"

namespace race::server {
namespace {

using namespace std::chrono_literals;

TEST(Deadlines, DoWorkInTheOrderOfItsTimes) {
  Deadlines deadlines;
  std::promise<void> last;
  std::vector<int> done;  // on its thread, until the last
  deadlines.after(600ms, [&] {
    done.push_back(3);
    last.set_value();
  });
  deadlines.after(300ms, [&] { done.push_back(2); });
  deadlines.after(0ms, [&] { done.push_back(1); });
  last.get_future().wait();
  EXPECT_EQ(done, (std::vector{1, 2, 3}));
}

TEST(Deadlines, WorkThatThrowsIsOver) {
  Deadlines deadlines;
  std::promise<void> last;
  deadlines.after(0ms, [] { throw std::runtime_error("no"); });
  deadlines.after(1ms, [&] { last.set_value(); });
  last.get_future().wait();
}

TEST(Deadlines, KeepNothingOfWhatHasCome) {
  Deadlines deadlines;
  const auto kept = std::make_shared<int>(0);
  std::promise<void> last;
  const auto far = deadlines.after(1h, [kept] { FAIL(); });
  const auto next = deadlines.after(30min, [kept] { FAIL(); });
  const auto done = deadlines.after(0ms, [&] { last.set_value(); });
  last.get_future().wait();
  EXPECT_EQ(deadlines.size(), 2U);
  for (const auto& id : {next, far, far, done}) deadlines.drop(id);
  EXPECT_EQ(deadlines.size(), 0U);
  EXPECT_EQ(kept.use_count(), 1);
  std::promise<void> later;
  deadlines.after(30ms, [&] { later.set_value(); });
  later.get_future().wait();
}

TEST(Deadlines, DropWhatIsNotDueWhenTheyAreClosed) {
  Deadlines deadlines;
  auto kept = std::make_shared<int>(0);
  deadlines.after(1h, [kept] { FAIL(); });
  deadlines.close();
  EXPECT_EQ(kept.use_count(), 1);
  deadlines.after(0ms, [kept] { FAIL(); });
  EXPECT_EQ(kept.use_count(), 1);
}

TEST(Done, OfOnceTheFirstCallCounts) {
  std::vector<int> given;
  Once<int> once([&](const Expected<int>& value) { given.push_back(value.value_or(0)); });
  once(1);
  once(unexpected(ErrorCode::unavailable, "late"));
  EXPECT_EQ(given, std::vector{1});
}

TEST(Done, WhoWaitsForOneThatIsDroppedLearnsIt) {
  EXPECT_EQ(wait_for<int>([](const Done<int>& done) { done(7); }).value(), 7);
  EXPECT_EQ(wait_for<int>([](const Done<int>&) {}).error().code, ErrorCode::unavailable);
}

}  // namespace
}  // namespace race::server
