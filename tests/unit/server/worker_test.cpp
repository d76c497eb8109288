// The thread for long work: bounded in what waits and in how long somebody waits.
#include "server/threads/worker.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace race::server {
namespace {

using namespace std::chrono_literals;

int five(const Worker::Stop&) { return 5; }

int until_stopped(const Worker::Stop& stop) {
  while (!stop) std::this_thread::yield();
  return 0;
}

// Work until `stop`, asked by somebody else.
std::future<ErrorCode> keep_busy(Worker& worker, std::chrono::milliseconds limit) {
  return std::async(std::launch::async, [&worker, limit] { return worker.ask(until_stopped, limit).error().code; });
}

TEST(Worker, GivesTheValue) {
  Worker worker;
  EXPECT_EQ(worker.ask(five, 1s).value(), 5);
}

TEST(Worker, StopsWorkThatTakesTooLong) {
  Worker worker;
  EXPECT_EQ(worker.ask(until_stopped, 1ms).error().code, ErrorCode::too_large);
  EXPECT_EQ(worker.ask(five, 1s).value(), 5) << "the thread is free again";
}

TEST(Worker, GivesWhoAsksTheExceptionAndIsFreeAgain) {
  Worker worker;
  for (std::size_t i = 0; i < 2 * Worker::kMost; ++i)
    EXPECT_THROW(worker.ask([](const Worker::Stop&) -> int { throw std::runtime_error("no"); }, 1s),
                 std::runtime_error);
  EXPECT_EQ(worker.ask(five, 1s).value(), 5);
}

TEST(Worker, HasABoundedQueue) {
  Worker worker;
  std::atomic<std::size_t> asked{0};
  std::promise<void> release;
  const auto released = release.get_future().share();
  std::vector<std::future<bool>> waiting;
  for (std::size_t i = 0; i < Worker::kMost; ++i)
    waiting.push_back(std::async(std::launch::async, [&] {
      ++asked;
      return worker.ask([released](const Worker::Stop&) { return released.wait(), true; }, 10s).has_value();
    }));
  while (asked < Worker::kMost) std::this_thread::yield();
  std::this_thread::sleep_for(50ms);
  const auto refused = worker.ask(five, 1s);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unavailable);
  release.set_value();
  for (auto& each : waiting) EXPECT_TRUE(each.get()) << "what was within the bound is done";
  EXPECT_EQ(worker.ask(five, 1s).value(), 5);
}

TEST(Worker, AnswersAllWhoWaitWhenItIsStopped) {
  Worker worker;
  auto running = keep_busy(worker, 1h), waiting = keep_busy(worker, 1h);
  std::this_thread::sleep_for(20ms);
  worker.stop();
  EXPECT_EQ(running.get(), ErrorCode::unavailable);
  EXPECT_EQ(waiting.get(), ErrorCode::unavailable);
  EXPECT_EQ(worker.ask(five, 1s).error().code, ErrorCode::unavailable);
}

}  // namespace
}  // namespace race::server
