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
  /// All that is durable up to this record.
  void release(std::uint64_t ticket) {
    held.set_durable(ticket);
    while (held.is_due()) held.say_next();
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
  release(second - 1);
  EXPECT_EQ(said, "ab");
  held.fail({ErrorCode::storage, "no"});
  EXPECT_EQ(said, "ab!");
}

TEST_F(HeldOutputsTest, AreSaidOneByOneAndKnowWhetherSomebodyWaits) {
  const auto ticket = held.next_ticket();
  held.add(output('a'));
  held.add(output('b'), 0, true);
  held.set_durable(ticket);
  EXPECT_EQ(said, "");
  EXPECT_TRUE(held.has_answers());
  held.say_next();
  held.add(output('c'));
  EXPECT_EQ(said, "a") << "in order";
  held.say_next();
  EXPECT_FALSE(held.has_answers());
  held.say_next();
  EXPECT_EQ(said, "abc");
  EXPECT_FALSE(held.is_due());
}

TEST_F(HeldOutputsTest, WaitForNothingThatWasDurableWhenTheJournalFailed) {
  const auto first = held.next_ticket();
  held.next_ticket();
  held.add(output('a'));
  held.fail({ErrorCode::storage, "no"});
  release(first);  // it was on its way
  held.add(output('b'));
  EXPECT_EQ(said, "!b");
}

TEST_F(HeldOutputsTest, AreFullByNumber) {
  const auto ticket = held.next_ticket();
  for (std::size_t i = 0; i < HeldOutputs::kMost; ++i) {
    EXPECT_FALSE(held.is_full());
    held.add(output('a'));
  }
  EXPECT_TRUE(held.is_full());
  release(ticket);
  EXPECT_FALSE(held.is_full());
}

TEST_F(HeldOutputsTest, AreFullByUnits) {
  const auto ticket = held.next_ticket();
  held.add(output('a'), HeldOutputs::kMostUnits - 1);
  EXPECT_FALSE(held.is_full());
  held.add(output('b'), 1);
  EXPECT_TRUE(held.is_full());
  release(ticket);
  EXPECT_FALSE(held.is_full());
  EXPECT_EQ(said, "ab");
}

}  // namespace
}  // namespace race::server
