// The thread for long work: bounded in what waits and in how long it takes; who asks waits on no thread.
#include "server/threads/worker.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <thread>

namespace race::server {
namespace {

using namespace std::chrono_literals;

Expected<int> five(const Stop&) { return 5; }

Expected<int> until_stopped(const Stop& stop) {
  while (!stop) std::this_thread::yield();
  return 0;
}

struct WorkerTest : testing::Test {
  using Function = std::function<Expected<int>(const Stop&)>;
  /// What comes of it later.
  std::future<Expected<int>> ask(Function function, std::chrono::milliseconds limit = 1h,
                                 SharedStop stop = std::make_shared<Stop>(false)) {
    auto promise = std::make_shared<std::promise<Expected<int>>>();
    auto value = promise->get_future();
    worker.ask<int>(std::move(function), {limit, {ErrorCode::too_large, "it takes long"}}, std::move(stop),
                    [promise](Expected<int> given) { promise->set_value(std::move(given)); });
    return value;
  }
  ErrorCode why_not(Function function, std::chrono::milliseconds limit = 1h) {
    return ask(std::move(function), limit).get().error().code;
  }

  Deadlines deadlines;
  Worker worker{deadlines};
};

TEST_F(WorkerTest, GivesTheValue) { EXPECT_EQ(ask(five).get().value(), 5); }

TEST_F(WorkerTest, GivesTheErrorOfTheWork) {
  EXPECT_EQ(why_not([](const Stop&) -> Expected<int> { return unexpected(ErrorCode::not_found, "no"); }),
            ErrorCode::not_found);
}

TEST_F(WorkerTest, StopsWorkThatTakesTooLong) {
  EXPECT_EQ(why_not(until_stopped, 1ms), ErrorCode::too_large);
  EXPECT_EQ(ask(five).get().value(), 5) << "the thread is free again";
}

TEST_F(WorkerTest, WorkThatThrowsIsAnErrorAndItIsFreeAgain) {
  for (std::size_t i = 0; i < 2 * Worker::kMost; ++i)
    EXPECT_EQ(why_not([](const Stop&) -> Expected<int> { throw std::runtime_error("no"); }), ErrorCode::unavailable);
  EXPECT_EQ(ask(five).get().value(), 5);
}

TEST_F(WorkerTest, HasABoundedQueue) {
  std::promise<void> release;
  const auto released = release.get_future().share();
  std::vector<std::future<Expected<int>>> waiting;
  for (std::size_t i = 0; i < Worker::kMost; ++i)
    waiting.push_back(ask([released](const Stop&) -> Expected<int> { return released.wait(), 1; }));
  EXPECT_EQ(why_not(five), ErrorCode::unavailable);
  release.set_value();
  for (auto& each : waiting) EXPECT_TRUE(each.get()) << "what was within the bound is done";
  EXPECT_EQ(ask(five).get().value(), 5);
}

TEST_F(WorkerTest, WorkThatNobodyWaitsForEndsAndDoesNotBegin) {
  const auto gone = std::make_shared<Stop>(false);
  bool begun = false;
  auto running = ask(until_stopped, 1h, gone);
  auto waiting = ask([&](const Stop&) -> Expected<int> { return begun = true; }, 1h, gone);
  auto other = ask(five);
  *gone = true;
  EXPECT_EQ(other.get().value(), 5);
  EXPECT_EQ(running.get().error().code, ErrorCode::unavailable);
  EXPECT_EQ(waiting.get().error().code, ErrorCode::unavailable);
  EXPECT_FALSE(begun);
}

TEST_F(WorkerTest, AnswersAllWhoWaitWhenItIsStopped) {
  auto running = ask(until_stopped), waiting = ask(until_stopped);
  worker.stop();
  EXPECT_EQ(running.get().error().code, ErrorCode::unavailable);
  EXPECT_EQ(waiting.get().error().code, ErrorCode::unavailable);
  EXPECT_EQ(why_not(five), ErrorCode::unavailable);
}

}  // namespace
}  // namespace race::server
