#include "services/host/work_queue.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "services/computed_time.h"
#include "services/failures.h"

namespace race::services {
namespace {

TEST(WorkQueue, RunsInOrderWhatWasPostedBefore) {
  WorkQueue queue;
  std::string text;
  queue.post([&] {
    text += "a";
    queue.post([&] { text += "c"; });
  });
  queue.post([&] { text += "b"; });
  EXPECT_TRUE(queue.run());
  EXPECT_EQ(text, "ab");
  EXPECT_TRUE(queue.run());
  EXPECT_EQ(text, "abc");
  EXPECT_FALSE(queue.run());
}

TEST(WorkQueue, RunsAPieceOfEachLaneInTurn) {
  WorkQueue queue;
  std::string text;
  for (const char c : {'a', 'b', 'c'}) queue.post([&text, c] { text += c; }, 1);
  for (const char c : {'A', 'B'}) queue.post([&text, c] { text += c; }, 2);
  queue.run_for(std::chrono::seconds(5));
  EXPECT_EQ(text, "aAbBc");
}

TEST(WorkQueue, RunsWhatHasNoLaneBeforeAllLanes) {
  WorkQueue queue;
  std::string text;
  for (const char c : {'a', 'b'}) queue.post([&text, c] { text += c; }, 1);
  for (const char c : {'.', ':'}) queue.post([&text, c] { text += c; });
  queue.post([&] { text += 'A'; }, 2);
  queue.run_for(std::chrono::seconds(5));
  EXPECT_EQ(text, ".:aAb");
}

TEST(WorkQueue, LeavesWhatItsTimeIsTooShortFor) {
  WorkQueue queue;
  std::string text;
  queue.post(
      [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        text += "a";
      },
      1);
  for (const char c : {'b', 'c'}) queue.post([&text, c] { text += c; }, 1);
  queue.run_for(std::chrono::milliseconds(1));
  EXPECT_EQ(text, "a");
  EXPECT_TRUE(queue.run());
  EXPECT_EQ(text, "abc");
}

TEST(WorkQueue, KeepsWhatIsBehindWorkThatThrows) {
  WorkQueue queue;
  std::string text;
  queue.post([&] { text += "a"; });
  queue.post([] { throw std::runtime_error("b"); });
  queue.post([&] { text += "c"; });
  EXPECT_THROW(queue.run(), std::runtime_error);
  queue.post([&] { text += "d"; });
  EXPECT_TRUE(queue.run());
  EXPECT_EQ(text, "acd");
}

TEST(WorkThread, GoesOnAfterWorkThatThrows) {
  int failures = 0, done = 0;  // of the thread alone, until it is gone
  set_failure_handler([&](const std::string&) { ++failures; });
  {
    WorkThread thread;
    for (int i = 0; i < 10; ++i) {
      thread.post([] { throw std::runtime_error("no"); });
      thread.post([&] { ++done; });
    }
  }
  set_failure_handler({});
  EXPECT_EQ(failures, 10);
  EXPECT_EQ(done, 10);
}

TEST(WorkThread, DropsWhatIsPostedAfterItsEnd) {
  WorkThread thread;
  int done = 0;
  const auto held = std::make_shared<int>();
  thread.post([&] { ++done; });
  thread.end();
  thread.post([&, held] { ++done; });
  EXPECT_EQ(done, 1);
  EXPECT_EQ(held.use_count(), 1);
}

TEST(WorkThread, UsesNoMoreThanItsShareOfAProcessor) {
  constexpr std::chrono::milliseconds kPiece{1};
  const auto begun = std::chrono::steady_clock::now();
  {
    WorkThread thread("test", 0.2);
    for (int i = 0; i < 20; ++i) {
      thread.post([kPiece] {
        const auto end = thread_time() + kPiece;
        while (thread_time() < end) continue;
      });
      std::this_thread::sleep_for(2 * kPiece);  // pieces by themselves
    }
  }
  EXPECT_GE(std::chrono::steady_clock::now() - begun, 4 * 20 * kPiece) << "five times, but for the last turn";
}

TEST(WorkThread, HasDoneEverythingWhenItIsGone) {
  int done = 0;
  {
    WorkThread thread;
    for (int i = 0; i < 1000; ++i) thread.post([&] { ++done; });
  }
  EXPECT_EQ(done, 1000);
}

}  // namespace
}  // namespace race::services
