#include "server/store/document_breakpoints.h"

#include "tests/unit/server/document_store.h"

namespace race::server {
namespace {

struct DocumentBreakpointsTest : DocumentStore {
  DocumentBreakpointsTest() {
    documents = open();
    EXPECT_TRUE(documents->put("task", kTask));
    breakpoints = DocumentBreakpoints::open(path()).value();
  }
  std::unique_ptr<Documents> documents;
  std::unique_ptr<DocumentBreakpoints> breakpoints;
};

const List kOne = {Dict{{"when", "entered"}, {"path", "R/A"}, {"enabled", true}}};
const List kOtherBreakpoints = {Dict{{"when", "fault"}, {"enabled", false}}};

TEST_F(DocumentBreakpointsTest, AreThoseOfEachPersonWhenTheStoreIsOpenedAgain) {
  ASSERT_TRUE(breakpoints->set("task", "Ada", kOne));
  ASSERT_TRUE(breakpoints->set("task", "Bob/", kOtherBreakpoints));
  breakpoints = DocumentBreakpoints::open(path()).value();
  EXPECT_EQ(breakpoints->get("task", "Ada"), kOne);
  EXPECT_EQ(breakpoints->get("task", "Bob/"), kOtherBreakpoints);
  EXPECT_EQ(breakpoints->get("task", "Eve"), List());
}

TEST_F(DocumentBreakpointsTest, AreReplacedWhole) {
  ASSERT_TRUE(breakpoints->set("task", "Ada", kOne));
  ASSERT_TRUE(breakpoints->set("task", "Ada", kOtherBreakpoints));
  EXPECT_EQ(breakpoints->get("task", "Ada"), kOtherBreakpoints);
  ASSERT_TRUE(breakpoints->set("task", "Ada", {}));
  EXPECT_EQ(breakpoints->get("task", "Ada"), List());
}

TEST_F(DocumentBreakpointsTest, GoWithTheirDocument) {
  ASSERT_TRUE(breakpoints->set("task", "Ada", kOne));
  ASSERT_TRUE(documents->remove("task"));
  EXPECT_EQ(breakpoints->get("task", "Ada"), List());
  EXPECT_EQ(breakpoints->set("task", "Ada", kOne).error().code, ErrorCode::not_found);
  ASSERT_TRUE(documents->put("task", kTask));
  EXPECT_EQ(breakpoints->get("task", "Ada"), List());
}

TEST_F(DocumentBreakpointsTest, AreBounded) {
  EXPECT_TRUE(breakpoints->set("task", "Ada", List(100, kOne[0])));
  EXPECT_EQ(breakpoints->set("task", "Ada", List(101, kOne[0])).error().code, ErrorCode::too_large);
  EXPECT_EQ(breakpoints->get("task", "Ada")->size(), 100U) << "what is refused changes nothing";
  EXPECT_EQ(breakpoints->get("task", "").error().code, ErrorCode::missing);
  EXPECT_EQ(breakpoints->set("task", std::string(101, 'a'), kOne).error().code, ErrorCode::too_large);
}

TEST_F(DocumentBreakpointsTest, OfTooManyPeopleForgetsWhoHasSetThemLongestAgo) {
  ASSERT_TRUE(documents->put("other", kTask));
  ASSERT_TRUE(breakpoints->set("other", "p0", kOne));
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(breakpoints->set("task", "p" + std::to_string(i), kOne));
  ASSERT_TRUE(breakpoints->set("task", "p0", kOtherBreakpoints));
  ASSERT_TRUE(breakpoints->set("task", "Ada", kOne));
  EXPECT_EQ(breakpoints->get("task", "p0"), kOtherBreakpoints);
  EXPECT_EQ(breakpoints->get("task", "p1"), List());
  EXPECT_EQ(breakpoints->get("task", "p2"), kOne);
  EXPECT_EQ(breakpoints->get("other", "p0"), kOne);
}

TEST_F(DocumentBreakpointsTest, NamesTheDocumentWhoseBreakpointsAreDamaged) {
  for (const char* damage : {"text = '[]'", "text = '['", "number = 7", "digest = x'00'", "author = 'Bob'"}) {
    ASSERT_TRUE(breakpoints->set("task", "Ada", kOne));
    ASSERT_TRUE(breakpoints->set("task", "Bob", {}));
    SQLite::Database(path(), SQLite::OPEN_READWRITE).exec(std::string("UPDATE document_breakpoints SET ") + damage);
    const auto read = breakpoints->get("task", std::string(damage).starts_with("author") ? "Bob" : "Ada");
    ASSERT_FALSE(read) << damage;
    EXPECT_EQ(read.error().code, ErrorCode::corrupt);
    EXPECT_EQ(read.error().path, "task");
  }
}

}  // namespace
}  // namespace race::server
