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

const std::string kFilling(SendQueue::kBytes - SendQueue::kOverheadBytes, 'x');

TEST(SendQueue, DropsAPacketThatFindsNoRoom) {
  SendQueue queue;
  EXPECT_TRUE(queue.push({kFilling}, "images"));
  EXPECT_FALSE(queue.push({"y"}, "clouds"));
  EXPECT_FALSE(queue.overflowed());
  EXPECT_TRUE(queue.push({"y"}, "images")) << "it takes the place of what filled the queue";
  EXPECT_TRUE(queue.push({"y"}));
  EXPECT_EQ(queue.size(), 2U);
}

TEST(SendQueue, IsClosedAndEmptyOnceAnotherMessageFindsNoRoom) {
  SendQueue queue;
  int woken = 0;
  EXPECT_TRUE(queue.push({kFilling}));
  queue.on_change([&] { ++woken; });
  EXPECT_FALSE(queue.push({""}));
  EXPECT_TRUE(queue.overflowed());
  EXPECT_TRUE(queue.drained());
  EXPECT_EQ(woken, 1) << "the connection is to end";
  EXPECT_FALSE(queue.push({"y"}));
  EXPECT_FALSE(queue.push({"y"}, "images"));
}

TEST(SendQueue, HasABoundForMessagesOfNoLengthToo) {
  SendQueue queue;
  std::size_t taken = 0;
  while (taken < SendQueue::kBytes / 100 && queue.push({""})) ++taken;
  EXPECT_EQ(taken, SendQueue::kBytes / SendQueue::kOverheadBytes);
}

TEST(SendQueue, HasRoomAgainForWhatHasLeft) {
  SendQueue queue;
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(queue.push({kFilling}, i == 1 ? "images" : ""));
    EXPECT_TRUE(queue.pop());
  }
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
  EXPECT_FALSE(queue.overflowed()) << "it was closed";
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
