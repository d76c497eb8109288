#include "server/http/wake_up.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>

namespace race::server {
namespace {

TEST(WakeUp, OneAtMostIsOnItsWayHoweverOftenItIsAskedFor) {
  boost::asio::io_context io;
  const WakeUp wake_up(io.get_executor());
  const WakeUp copy = wake_up;
  int woken = 0;
  for (int i = 0; i < 1000; ++i) (i % 2 == 0 ? wake_up : copy).post([&] { ++woken; });
  EXPECT_EQ(io.poll(), 1U);
  EXPECT_EQ(woken, 1);
}

TEST(WakeUp, WhatIsAskedForWhileItIsDoneComesAfterIt) {
  boost::asio::io_context io;
  const WakeUp wake_up(io.get_executor());
  int woken = 0;
  wake_up.post([&] {
    wake_up.post([&] { woken = 2; });
    woken = 1;
  });
  io.poll();
  EXPECT_EQ(woken, 2);
}

}  // namespace
}  // namespace race::server
