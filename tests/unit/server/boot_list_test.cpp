#include "server/store/boot_list.h"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>

#include "server/store/data_folder.h"
#include "tests/unit/server/bench.h"

namespace race::server {
namespace {

struct BootListTest : testing::Test {
  BootListTest() {
    store = DataFolder::open(place.path)->store();  // with all tables
    list = BootList::open(store).value();
  }

  TemporaryFolder place;
  std::string store;
  std::unique_ptr<BootList> list;
};

const std::vector<BootEntry> kTwo = {{"pick", Dict{{"name", "part"}, {"at", List{1, 2.5, nullptr}}}}, {"watch", {}}};

TEST_F(BootListTest, IsEmptyAtFirst) { EXPECT_EQ(list->get(), std::vector<BootEntry>()); }

TEST_F(BootListTest, IsThereInItsOrderWhenItIsOpenedAgain) {
  ASSERT_TRUE(list->set(kTwo));
  list.reset();
  EXPECT_EQ(BootList::open(store).value()->get(), kTwo);
}

TEST_F(BootListTest, IsReplacedWhole) {
  ASSERT_TRUE(list->set(kTwo));
  const std::vector<BootEntry> one = {{"watch", Dict{{"n", 1}}}};
  ASSERT_TRUE(list->set(one));
  EXPECT_EQ(list->get(), one);
  ASSERT_TRUE(list->set({}));
  EXPECT_EQ(list->get(), std::vector<BootEntry>());
}

TEST_F(BootListTest, HasAtMostSixtyFourEntries) {
  std::vector<BootEntry> entries;
  for (int i = 0; i < 64; ++i) entries.push_back({"d" + std::to_string(i), {}});
  EXPECT_TRUE(list->set(entries));
  EXPECT_EQ(list->get()->size(), 64U);
  entries.push_back({"d64", {}});
  EXPECT_EQ(list->set(entries).error().code, ErrorCode::too_large);
  EXPECT_EQ(list->get()->size(), 64U) << "what is refused changes nothing";
}

TEST_F(BootListTest, HasADocumentOnce) {
  ASSERT_TRUE(list->set(kTwo));
  const auto set = list->set({{"a", {}}, {"b", {}}, {"a", Dict{{"n", 1}}}});
  ASSERT_FALSE(set);
  EXPECT_EQ(set.error().code, ErrorCode::duplicate);
  EXPECT_EQ(set.error().path, "entries/2/document");
  EXPECT_EQ(list->get(), kTwo);
}

TEST_F(BootListTest, NamesADamagedEntry) {
  for (const char* damage :
       {"document = 'x'", "arguments = '{}'", "arguments = '['", "digest = x'00'", "position = 7"}) {
    ASSERT_TRUE(list->set({{"watch", {}}, kTwo[0]}));
    SQLite::Database(store, SQLite::OPEN_READWRITE)
        .exec(std::string("UPDATE boot SET ") + damage + " WHERE position = 1");
    const auto read = list->get();
    ASSERT_FALSE(read) << damage;
    EXPECT_EQ(read.error().code, ErrorCode::corrupt);
    EXPECT_EQ(read.error().path, "entries/1");
  }
}

}  // namespace
}  // namespace race::server
