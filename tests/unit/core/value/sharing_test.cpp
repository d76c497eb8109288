// Copy-on-write and freezing: a change does not affect copies, and frozen values may cross threads.
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "core/value/value.h"

namespace race {
namespace {

TEST(CopyOnWrite, CopiesShareUntilOneChanges) {
  const Value original(List{1, 2});
  Value copy = original;
  EXPECT_TRUE(copy.identical(original));
  copy.mutable_list().push_back(3);
  EXPECT_FALSE(copy.identical(original));
  EXPECT_EQ(original, Value(List{1, 2}));
  EXPECT_EQ(copy, Value(List{1, 2, 3}));
}

TEST(CopyOnWrite, ASoleOwnerChangesInPlace) {
  Value alone(List{1});
  const List* before = &alone.as_list();
  alone.mutable_list().push_back(2);
  EXPECT_EQ(&alone.as_list(), before);
}

TEST(CopyOnWrite, CopiesOneLevelAndSharesTheNext) {
  const Value original(List{List{1}, List{2}});
  Value copy = original;
  copy.mutable_list()[0].mutable_list()[0] = 9;
  EXPECT_EQ(original, Value(List{List{1}, List{2}}));
  EXPECT_EQ(copy, Value(List{List{9}, List{2}}));
  EXPECT_TRUE(copy.as_list()[1].identical(original.as_list()[1]));
}

TEST(CopyOnWrite, HoldsForDictsAndTheirEntries) {
  const Value original(Dict{{"pose", Dict{{"x", 1}}}});
  Value copy = original;
  copy.mutable_dict().find(Value("pose"))->mutable_dict().set("x", 2);
  EXPECT_EQ(original, Value(Dict{{"pose", Dict{{"x", 1}}}}));
  EXPECT_EQ(copy, Value(Dict{{"pose", Dict{{"x", 2}}}}));
}

TEST(CopyOnWrite, AListCanContainACopyOfItself) {
  Value list(List{1});
  const Value copy = list;
  list.mutable_list().push_back(copy);
  EXPECT_EQ(list, Value(List{1, List{1}}));
}

TEST(Freeze, ReachesEveryLevelAndKeepsTheValue) {
  Value value(Dict{{"a", List{Value(List{"deep"})}}});
  const Value same(Dict{{"a", List{Value(List{"deep"})}}});
  value.freeze();
  EXPECT_EQ(value, same);
  Value inner = value.find("a")->as_list()[0];
  inner.mutable_list()[0] = "changed";
  EXPECT_EQ(value, same);
  EXPECT_EQ(inner, Value(List{"changed"}));
}

TEST(Freeze, AChangeOfAFrozenValueCopiesEvenForItsSoleOwner) {
  Value value(List{1});
  value.freeze();
  const List* frozen = &value.as_list();
  value.mutable_list().push_back(2);
  EXPECT_NE(&value.as_list(), frozen);
  EXPECT_EQ(value, Value(List{1, 2}));
}

TEST(Freeze, FrozenValuesAreCopiedChangedAndDroppedByThreadsAtOnce) {
  Value shared(Dict{{"list", List{"text", Dict{{"n", 1}}}}});
  shared.freeze();
  const Value expected = shared;
  std::vector<int> sums(4);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < sums.size(); ++t) {
      threads.emplace_back([own = shared, &sum = sums[t]]() mutable {
        for (int i = 0; i < 1000; ++i) {
          Value copy = own;
          copy.mutable_dict().find(Value("list"))->mutable_list().push_back(i);
          sum += static_cast<int>(copy.find("list")->as_list().size());
        }
      });
    }
  }
  EXPECT_EQ(sums, std::vector<int>(4, 3000));
  EXPECT_EQ(shared, expected);
}

}  // namespace
}  // namespace race
