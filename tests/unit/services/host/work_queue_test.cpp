#include "services/host/work_queue.h"

#include <gtest/gtest.h>

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
