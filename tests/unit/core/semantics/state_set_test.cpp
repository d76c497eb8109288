// StateSet against std::set, on random sequences and at the borders of its words.
#include "core/semantics/state_set.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace race::semantics {
namespace {

std::vector<std::uint32_t> walk(const StateSet& set) {
  std::vector<std::uint32_t> out;
  for (StateId s = set.next(0); s != kNoState; s = set.next(index(s) + 1)) out.push_back(index(s));
  return out;
}

class StateSetOfSize : public testing::TestWithParam<std::uint32_t> {};

TEST_P(StateSetOfSize, WalksItsMembersInOrder) {
  const std::uint32_t size = GetParam();
  std::mt19937 random(size);
  StateSet set(size);
  std::set<std::uint32_t> expected;
  for (int i = 0; i < 3000; ++i) {
    const auto s = static_cast<std::uint32_t>(random() % size);
    if (random() % 3 != 0) {
      set.add(StateId{s});
      expected.insert(s);
    } else {
      set.remove(StateId{s});
      expected.erase(s);
    }
    const auto from = static_cast<std::uint32_t>(random() % (size + 1));
    const auto next = expected.lower_bound(from);
    ASSERT_EQ(index(set.next(from)), next == expected.end() ? kNone : *next) << "size " << size << ", operation " << i;
    ASSERT_EQ(set.empty(), expected.empty());
  }
  EXPECT_EQ(walk(set), std::vector<std::uint32_t>(expected.begin(), expected.end()));
}

INSTANTIATE_TEST_SUITE_P(Sizes, StateSetOfSize, testing::Values(1, 2, 63, 64, 65, 128, 4095, 4096, 4097, 300000));

TEST(StateSet, FindsAMemberAddedBehindTheWalk) {
  StateSet set(200);
  set.add(StateId{3});
  set.add(StateId{150});
  EXPECT_EQ(index(set.next(4)), 150u);
  set.add(StateId{70});
  EXPECT_EQ(index(set.next(4)), 70u);
}

}  // namespace
}  // namespace race::semantics
