// What a Value is and when two of them are equal.
#include "core/value/value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace race {
namespace {

TEST(Value, IsNullByDefault) {
  EXPECT_TRUE(Value().is_null());
  EXPECT_EQ(Value(), Value(nullptr));
}

TEST(Value, KeepsWhatItWasMadeOf) {
  EXPECT_TRUE(Value(true).as_bool());
  EXPECT_FALSE(Value(false).as_bool());
  EXPECT_EQ(Value(std::numeric_limits<std::int64_t>::min()).as_integer(), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(Value(-0.25).as_number(), -0.25);
  EXPECT_EQ(Value("grasp").as_string(), "grasp");
  EXPECT_EQ(Value(List{1, "a"}).as_list().at(1).as_string(), "a");
  EXPECT_EQ(Value(Dict{{"width", 0.05}}).find("width")->as_number(), 0.05);
}

TEST(Value, DistinguishesTrueOneAndOnePointZero) {
  EXPECT_NE(Value(true), Value(1));
  EXPECT_NE(Value(1), Value(1.0));
  EXPECT_NE(Value(false), Value());
  EXPECT_NE(Value(), Value::unknown());
  EXPECT_NE(Value("1"), Value(1));
}

TEST(Value, ComparesDoublesBitByBit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Value(nan), Value(nan));
  EXPECT_NE(Value(0.0), Value(-0.0));
}

TEST(Value, ComparesListsInOrderAndDictsInAnyOrder) {
  EXPECT_EQ(Value(List{1, 2}), Value(List{1, 2}));
  EXPECT_NE(Value(List{1, 2}), Value(List{2, 1}));
  EXPECT_EQ(Value(Dict{{"a", 1}, {"b", List{2}}}), Value(Dict{{"b", List{2}}, {"a", 1}}));
  EXPECT_NE(Value(Dict{{"a", 1}}), Value(Dict{{"a", 1}, {"b", 2}}));
  EXPECT_NE(Value(Dict{{"a", 1}}), Value(Dict{{"b", 1}}));
}

TEST(Value, FindsOnlyEntriesOfDicts) {
  EXPECT_EQ(Value(Dict{{"a", 1}}).find("b"), nullptr);
  EXPECT_EQ(Value(List{1}).find("a"), nullptr);
  EXPECT_EQ(Value(1).find("a"), nullptr);
}

TEST(Value, CanBeAssignedAPartOfItself) {
  Value copied(List{List{1, 2}, "rest"});
  copied = copied.as_list().front();
  EXPECT_EQ(copied, Value(List{1, 2}));
  Value moved(Dict{{"inner", List{1, 2}}});
  moved = std::move(*moved.mutable_dict().find(Value("inner")));
  EXPECT_EQ(moved, Value(List{1, 2}));
  copied = *&copied;
  EXPECT_EQ(copied, Value(List{1, 2}));
}

TEST(Value, CountsElementsEntriesAndBytes) {
  EXPECT_EQ(Value(7).size_units(), 1U);
  EXPECT_EQ(Value("abc").size_units(), 4U);
  EXPECT_EQ(Value(List{1, 2, List{3}}).size_units(), 1U + 1U + 1U + 2U);
  EXPECT_EQ(Value(Dict{{"k", "v"}}).size_units(), 1U + 2U + 2U);
}

TEST(Value, FindsAnInfinityAtAnyLevel) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(Value(List{1.5, Dict{{"x", 1e308}}}).is_finite());
  EXPECT_FALSE(Value(-infinity).is_finite());
  EXPECT_FALSE(Value(List{1, Dict{{"x", List{std::nan("")}}}}).is_finite());
}

}  // namespace
}  // namespace race
