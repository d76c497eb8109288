// Dict keeps the order of insertion, both small (searched linearly) and large (through its index).
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/value/value.h"

namespace race {
namespace {

using Entries = std::vector<std::pair<std::string, int>>;

// As a reader looks it up; the dict is not to be changed through it.
const Value* find(const Dict& dict, std::string_view key) { return dict.find(key); }

Entries entries(const Dict& dict) {
  Entries out;
  for (const auto& [key, value] : dict) out.emplace_back(key.as_string(), static_cast<int>(value.as_integer()));
  return out;
}

TEST(Dict, KeepsTheOrderOfInsertion) {
  Dict dict{{"z", 1}, {"a", 2}};
  dict.set("m", 3);
  EXPECT_EQ(entries(dict), (Entries{{"z", 1}, {"a", 2}, {"m", 3}}));
}

TEST(Dict, SettingAKeyAgainKeepsItsPlace) {
  Dict dict{{"a", 1}, {"b", 2}, {"a", 3}};
  EXPECT_EQ(entries(dict), (Entries{{"a", 3}, {"b", 2}}));
}

TEST(Dict, AnErasedKeyIsGoneAndComesBackAtTheEnd) {
  Dict dict{{"a", 1}, {"b", 2}, {"c", 3}};
  EXPECT_TRUE(dict.erase("a"));
  EXPECT_FALSE(dict.erase("a"));
  EXPECT_EQ(find(dict, "a"), nullptr);
  dict.set("a", 4);
  EXPECT_EQ(entries(dict), (Entries{{"b", 2}, {"c", 3}, {"a", 4}}));
}

TEST(Dict, FindsByTextByEqualStringAndByTheSameString) {
  const Value key("key");
  Dict dict;
  dict.set(key, 1);
  EXPECT_EQ(find(dict, "key")->as_integer(), 1);
  EXPECT_EQ(dict.find(key)->as_integer(), 1);
  EXPECT_EQ(std::as_const(dict).find(Value("key"))->as_integer(), 1);
  EXPECT_EQ(dict.find(Value("other")), nullptr);
}

TEST(Dict, DistinguishesKeysWithZeroBytes) {
  using namespace std::string_literals;
  Dict dict;
  dict.set("a\0x"s, 1);
  dict.set("a"s, 2);
  EXPECT_EQ(dict.size(), 2U);
  EXPECT_EQ(find(dict, "a\0x"s)->as_integer(), 1);
}

TEST(Dict, AClearedDictCanBeUsedAgain) {
  Dict dict;
  for (int i = 0; i < 50; ++i) dict.set(std::to_string(i), i);
  dict.clear();
  EXPECT_TRUE(dict.empty());
  EXPECT_EQ(find(dict, "7"), nullptr);
  dict.set("7", 8);
  EXPECT_EQ(entries(dict), (Entries{{"7", 8}}));
}

TEST(Dict, IsSortedIfEachKeyIsBeforeTheNextByteByByte) {
  EXPECT_TRUE(Dict().is_sorted());
  EXPECT_TRUE((Dict{{"b", 1}}).is_sorted());
  EXPECT_TRUE((Dict{{"", 4}, {"B", 3}, {"a", 2}, {"aa", 1}}).is_sorted());
  EXPECT_TRUE((Dict{{"z", 1}, {"\xc3\xa4", 2}}).is_sorted()) << "bytes are unsigned";
  EXPECT_FALSE((Dict{{"\xc3\xa4", 1}, {"z", 2}}).is_sorted());
  EXPECT_FALSE((Dict{{"b", 1}, {"a", 2}}).is_sorted());
  EXPECT_FALSE((Dict{{"a", 1}, {"b", 2}, {"d", 3}, {"c", 4}}).is_sorted());
}

TEST(Dict, SortedHasTheSameEntriesInOrderAndFindsEach) {
  EXPECT_TRUE(Dict().sorted().empty());
  for (const int count : {1, 2, 11, 12, 13, 60}) {
    Dict dict;
    for (int i = 0; i < count; ++i) dict.set(std::to_string(i * 7919 % count), i);
    const Dict sorted = dict.sorted();
    EXPECT_TRUE(sorted.is_sorted()) << count;
    EXPECT_EQ(sorted, dict) << count;
    for (const auto& [key, value] : dict) EXPECT_EQ(find(sorted, key.as_string())->as_integer(), value.as_integer());
    EXPECT_EQ(find(sorted, "other"), nullptr);
    EXPECT_EQ(dict.begin()->second.as_integer(), 0) << "the dict itself keeps its order";
  }
}

// The plain way to keep entries, to compare with.
struct PlainEntries {
  Entries list;
  Entries::iterator find(const std::string& key) {
    return std::ranges::find(list, key, &std::pair<std::string, int>::first);
  }
  void set(const std::string& key, int value) {
    if (const auto found = find(key); found != list.end()) {
      found->second = value;
    } else {
      list.emplace_back(key, value);
    }
  }
  bool erase(const std::string& key) {
    const auto found = find(key);
    if (found == list.end()) return false;
    list.erase(found);
    return true;
  }
};

TEST(Dict, AgreesWithAPlainListOfEntriesAfterEveryRandomChange) {
  const unsigned seed = 20;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (const int keys : {3, 14, 60}) {
    Dict dict;
    PlainEntries plain;
    for (int step = 0; step < 3000; ++step) {
      const std::string key = "key" + std::to_string(static_cast<int>(random() % static_cast<unsigned>(keys)));
      if (random() % 3 == 0) {
        ASSERT_EQ(dict.erase(key), plain.erase(key));
      } else {
        dict.set(key, step);
        plain.set(key, step);
      }
      ASSERT_EQ(entries(dict), plain.list);
      const std::string asked = "key" + std::to_string(static_cast<int>(random() % static_cast<unsigned>(keys)));
      const Value* found = find(dict, asked);
      ASSERT_EQ(found != nullptr, plain.find(asked) != plain.list.end());
      if (found != nullptr) {
        ASSERT_EQ(found->as_integer(), plain.find(asked)->second);
      }
    }
  }
}

}  // namespace
}  // namespace race
