#include "server/http/byte_budget.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

constexpr std::size_t kFree = ByteBudget::kFreeBytes;

TEST(ByteBudget, GivesSharesUntilNothingIsLeft) {
  ByteBudget budget(4 * kFree);
  const auto first = budget.take(3 * kFree);
  EXPECT_TRUE(first);
  EXPECT_FALSE(budget.take(2 * kFree));
  EXPECT_EQ(budget.left(), kFree);
}

TEST(ByteBudget, GetsBackWhatIsHeldNoMore) {
  ByteBudget budget(4 * kFree);
  {
    auto first = budget.take(2 * kFree);
    ByteBudget::Share moved = std::move(*first);
    first.reset();
    EXPECT_EQ(budget.left(), 2 * kFree) << "moved, not given back";
    moved = std::move(*budget.take(2 * kFree));
    EXPECT_EQ(budget.left(), 2 * kFree) << "replaced";
    moved = {};
    EXPECT_EQ(budget.left(), 4 * kFree);
    moved = std::move(*budget.take(2 * kFree));
  }
  EXPECT_EQ(budget.left(), 4 * kFree);
}

TEST(ByteBudget, WhatIsSmallTakesNothing) {
  ByteBudget budget(2 * kFree);
  const auto all = budget.take(2 * kFree);
  EXPECT_TRUE(budget.take(kFree));
  EXPECT_FALSE(budget.take(kFree + 1));
}

TEST(ByteBudget, WhatIsLargerThanTheWholeIsThereAlone) {
  ByteBudget budget(2 * kFree);
  {
    const auto large = budget.take(9 * kFree);
    EXPECT_TRUE(large);
    EXPECT_EQ(budget.left(), 0U);
  }
  const auto other = budget.take(kFree + 1);
  EXPECT_FALSE(budget.take(9 * kFree));
}

}  // namespace
}  // namespace race::server
