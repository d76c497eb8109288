#include "server/threads/strand.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

namespace race::server {
namespace {

TEST(Strand, RunsInOrderAndNeverTwoAtATime) {
  Pool pool(4);
  Strand strand(pool);
  std::vector<int> order;  // unguarded: the strand is the guard
  for (int i = 0; i < 2000; ++i) strand.post([&order, i] { order.push_back(i); });
  EXPECT_EQ(strand.ask([&] { return order.size(); }), 2000U);
  for (int i = 0; i < 2000; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(Strand, ABusyOneDoesNotHoldUpAnother) {
  Pool pool(2);
  Strand busy(pool), other(pool);
  std::atomic<bool> release{false};
  busy.post([&] {
    while (!release) std::this_thread::yield();
  });
  EXPECT_EQ(other.ask([] { return 5; }), 5);
  EXPECT_EQ(busy.ask([] { return 5; }, std::chrono::milliseconds(1)), std::nullopt);
  release = true;
  EXPECT_EQ(busy.ask([] { return 6; }), 6);
}

TEST(Pool, DoesEverythingBeforeItEnds) {
  std::atomic<int> done{0};
  {
    Pool pool(2);
    const auto strand = std::make_shared<Strand>(pool);  // its tasks, which post another one, keep it
    for (int i = 0; i < 100; ++i)
      strand->post([&done, strand] {
        ++done;
        strand->post([&done, strand] { ++done; });
      });
  }
  EXPECT_EQ(done, 200);
}

}  // namespace
}  // namespace race::server
