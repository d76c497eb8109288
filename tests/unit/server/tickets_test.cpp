#include "server/accounts/tickets.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

using namespace std::chrono_literals;

const Identity kAda{"ada", Role::developer, {}, "digest", "10.0.0.7"};

TEST(Tickets, OpenOneWebSocketEach) {
  Tickets tickets;
  const std::string one = tickets.issue(kAda, {}), other = tickets.issue(kAda, {});
  EXPECT_NE(one, other);
  EXPECT_EQ(tickets.take(one, {}), kAda);
  EXPECT_FALSE(tickets.take(one, {}));
  EXPECT_EQ(tickets.take(other, {}), kAda);
}

TEST(Tickets, AreGoodForHalfAMinute) {
  Tickets tickets;
  const std::string early = tickets.issue(kAda, {}), late = tickets.issue(kAda, {});
  EXPECT_TRUE(tickets.take(early, Tickets::Time{} + 30s - 1ns));
  EXPECT_FALSE(tickets.take(late, Tickets::Time{} + 30s));
}

TEST(Tickets, AreSecrets) {
  Tickets tickets;
  EXPECT_FALSE(tickets.take("", {}));
  EXPECT_FALSE(tickets.take("ticket_", {}));
  EXPECT_GE(tickets.issue(kAda, {}).size(), std::string("ticket_").size() + 43);
}

TEST(Tickets, BeyondTheBoundTheOldestGo) {
  Tickets tickets;
  std::vector<std::string> issued;
  for (std::size_t i = 0; i <= Tickets::kMost; ++i)
    issued.push_back(tickets.issue(kAda, Tickets::Time{} + std::chrono::milliseconds(i)));
  EXPECT_FALSE(tickets.take(issued.front(), Tickets::Time{} + 2s));
  EXPECT_TRUE(tickets.take(issued[1], Tickets::Time{} + 2s));
  EXPECT_TRUE(tickets.take(issued.back(), Tickets::Time{} + 2s));
}

}  // namespace
}  // namespace race::server
