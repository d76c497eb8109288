// What a core holds until it is durable: order, and the bounds.
#include "server/execution/held_outputs.h"

#include <gtest/gtest.h>

#include <string>

namespace race::server {
namespace {

struct HeldOutputsTest : testing::Test {
  HeldOutputs::Output output(char name) {
    return [this, name](const Error* failure) { said += failure ? '!' : name; };
  }
  HeldOutputs held;
  std::string said;
};

TEST_F(HeldOutputsTest, ComeInOrderWhenTheirRecordsAreDurable) {
  held.add(output('a'));
  EXPECT_EQ(said, "a") << "nothing waits for the disk";
  held.next_ticket();
  held.add(output('b'));
  const auto second = held.next_ticket();
  held.add(output('c'));
  EXPECT_EQ(said, "a");
  held.release(second - 1);
  EXPECT_EQ(said, "ab");
  held.fail({ErrorCode::storage, "no"});
  EXPECT_EQ(said, "ab!");
}

TEST_F(HeldOutputsTest, AreFullByNumber) {
  const auto ticket = held.next_ticket();
  for (std::size_t i = 0; i < HeldOutputs::kMost; ++i) {
    EXPECT_FALSE(held.is_full());
    held.add(output('a'));
  }
  EXPECT_TRUE(held.is_full());
  held.release(ticket);
  EXPECT_FALSE(held.is_full());
}

TEST_F(HeldOutputsTest, AreFullByUnits) {
  const auto ticket = held.next_ticket();
  held.add(output('a'), HeldOutputs::kMostUnits - 1);
  EXPECT_FALSE(held.is_full());
  held.add(output('b'), 1);
  EXPECT_TRUE(held.is_full());
  held.release(ticket);
  EXPECT_FALSE(held.is_full());
  EXPECT_EQ(said, "ab");
}

}  // namespace
}  // namespace race::server
