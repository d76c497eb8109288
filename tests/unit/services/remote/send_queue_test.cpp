#include "services/remote/send_queue.h"

#include <gtest/gtest.h>

namespace race::remote {
namespace {

TEST(SendQueue, GivesMessagesInTheirOrder) {
  SendQueue queue;
  EXPECT_TRUE(queue.push({"a"}));
  EXPECT_TRUE(queue.push({"b", true}));
  EXPECT_EQ(queue.pop()->bytes, "a");
  EXPECT_TRUE(queue.pop()->binary);
  EXPECT_FALSE(queue.pop());
}

TEST(SendQueue, KeepsOfAFlowTheNewestAlone) {
  SendQueue queue;
  queue.push({"old"}, "images");
  queue.push({"other"}, "clouds");
  queue.push({"new"}, "images");
  EXPECT_EQ(queue.pop()->bytes, "other");
  EXPECT_EQ(queue.pop()->bytes, "new");
  EXPECT_FALSE(queue.pop());
}

TEST(SendQueue, TakesNoMoreThanItsBytes) {
  SendQueue queue;
  EXPECT_TRUE(queue.push({std::string(SendQueue::kBytes, 'x')}, "images"));
  EXPECT_FALSE(queue.push({"y"}));
  EXPECT_TRUE(queue.push({"y"}, "images")) << "it takes the place of what filled the queue";
  EXPECT_TRUE(queue.push({"y"}));
}

TEST(SendQueue, WakesWhoSends) {
  SendQueue queue;
  int woken = 0;
  queue.on_change([&] { ++woken; });
  queue.push({"a"});
  queue.close();
  EXPECT_EQ(woken, 2);
  EXPECT_FALSE(queue.push({"b"}));
  EXPECT_EQ(woken, 2);
}

TEST(SendQueue, IsDrainedOnceItIsClosedAndAllHasLeft) {
  SendQueue queue;
  queue.push({"a"});
  EXPECT_FALSE(queue.drained());
  queue.close();
  EXPECT_FALSE(queue.drained());
  EXPECT_TRUE(queue.pop());
  EXPECT_TRUE(queue.drained());
}

}  // namespace
}  // namespace race::remote
