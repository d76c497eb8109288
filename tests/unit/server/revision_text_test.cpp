// Texts that are stored as edits: where whole texts stand between them, and what becomes of damage in any link.
#include "server/store/revision_text.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "tests/unit/server/edited_document.h"

namespace race::server {
namespace {

constexpr std::int64_t kEdits = 2 * kLongestChain + 10;

class RevisionTexts : public DocumentStore {
 protected:
  RevisionTexts() {
    documents_ = open();
    documents_->put("task", kWithIds).value();
  }
  void edit(std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i)
      EXPECT_TRUE(append(*documents_, set_doc("a", "edit " + std::to_string(i)), "t-" + std::to_string(i)));
  }
  std::string text(std::int64_t number) {
    const auto entry = documents_->entry("task", number);
    return entry ? to_json(entry->document) : entry.error().front().path + ": " + entry.error().front().message;
  }
  void execute(const std::string& sql) const { SQLite::Database(path(), SQLite::OPEN_READWRITE).exec(sql); }
  std::vector<std::int64_t> whole() const {
    SQLite::Database file(path());
    SQLite::Statement select(file, "SELECT number FROM revision WHERE text <> '' ORDER BY number");
    std::vector<std::int64_t> out;
    while (select.executeStep()) out.push_back(select.getColumn(0).getInt64());
    return out;
  }
  /// The revisions that need the link: those after it up to the next whole text.
  bool needs(std::int64_t revision, std::int64_t link) const {
    const auto texts = whole();
    const auto base = std::ranges::upper_bound(texts, revision) - 1;
    return *base < link && link <= revision;
  }

  std::unique_ptr<Documents> documents_;
};

TEST_F(RevisionTexts, AreWholeEverySoManyRevisionsAndReadAsTheyWereStored) {
  std::vector<std::string> texts{"", text(1)};
  for (std::int64_t i = 0; i < kEdits; ++i) {
    const edit::Edit edit = set_doc(i % 2 == 0 ? "a" : "b", "edit " + std::to_string(i));
    const RevisionText next = next_of(*documents_, edit);
    texts.push_back(to_json(parse_json(next.text).value()));
    ASSERT_TRUE(documents_->append_edit(next, {edit}));
  }
  EXPECT_EQ(whole(), (std::vector<std::int64_t>{1, 1 + kLongestChain + 1, 1 + 2 * (kLongestChain + 1)}));
  documents_ = open();
  for (std::int64_t number = 1; number <= kEdits + 1; ++number)
    EXPECT_EQ(text(number), texts[static_cast<std::size_t>(number)]) << number;
}

TEST_F(RevisionTexts, AreWholeWhereTheEditIsLonger) {
  edit::Edit edit;
  for (int i = 0; i < 100; ++i) edit.operations.push_back(set_doc("a", std::to_string(i)).operations.front());
  ASSERT_TRUE(append(*documents_, edit));
  EXPECT_EQ(whole(), (std::vector<std::int64_t>{1, 2}));
  ASSERT_TRUE(append(*documents_, set_doc("a", "short")));
  EXPECT_EQ(whole(), (std::vector<std::int64_t>{1, 2}));
  EXPECT_NE(text(3).find("short"), std::string::npos);
}

TEST_F(RevisionTexts, ThatNeedADamagedLinkAreCorruptAndTheOthersAreNot) {
  edit(kLongestChain + 4);
  documents_.reset();
  const auto before = std::filesystem::path(path() + ".before");
  std::filesystem::copy_file(path(), before);
  const std::int64_t last = kLongestChain + 5;
  for (const std::int64_t link : {2L, 3L, kLongestChain + 1, kLongestChain + 2, kLongestChain + 3, last})
    for (const char* damage : {"UPDATE revision_edit SET edit = replace(edit, 'edit', 'exit')",
                               "UPDATE revision_edit SET depth = depth + 1", "UPDATE revision_edit SET depth = 0",
                               "UPDATE revision_edit SET request = 'x'", "UPDATE revision_edit SET edit = ''",
                               "UPDATE revision_edit SET digest = zeroblob(32)", "DELETE FROM revision_edit"}) {
      SCOPED_TRACE(std::to_string(link) + ": " + damage);
      std::filesystem::copy_file(before, path(), std::filesystem::copy_options::overwrite_existing);
      execute(damage + (" WHERE number = " + std::to_string(link)));
      documents_ = Documents::open(path()).value();
      for (const std::int64_t number : {link - 1, link, kLongestChain + 1, kLongestChain + 2, last}) {
        const auto entry = documents_->entry("task", number);
        ASSERT_EQ(entry.has_value(), !needs(number, link) || whole().back() == number) << number;
        if (entry) continue;
        EXPECT_EQ(error_of(entry).code, ErrorCode::corrupt);
        EXPECT_EQ(error_of(entry).path, "task/revisions/" + std::to_string(link)) << number;
      }
      documents_.reset();
    }
}

TEST_F(RevisionTexts, OfADamagedBaseAreCorruptAndNameIt) {
  edit(3);
  execute("UPDATE revision SET text = text || ' ' WHERE number = 1");
  for (std::int64_t number = 1; number <= 4; ++number) {
    const auto entry = documents_->entry("task", number);
    EXPECT_EQ(error_of(entry).code, ErrorCode::corrupt);
    EXPECT_EQ(error_of(entry).path, "task/revisions/1");
  }
}

TEST_F(RevisionTexts, AreWholeAfterALinkThatIsDamaged) {
  for (const char* damage :
       {"UPDATE revision_edit SET request = 'x' WHERE number = ", "DELETE FROM revision_edit WHERE number = "}) {
    SCOPED_TRACE(damage);
    edit(2);
    const RevisionText next = next_of(*documents_, set_doc("b", "after"));
    execute(damage + std::to_string(next.revision.number - 1));
    ASSERT_TRUE(documents_->append_edit(next, {set_doc("b", "after")})) << "as a session in memory would";
    EXPECT_EQ(text(next.revision.number), to_json(parse_json(next.text).value()));
    EXPECT_FALSE(documents_->entry("task", next.revision.number - 1));
  }
}

TEST_F(RevisionTexts, HaveAPastThatEndsWhereItCannotBeRead) {
  edit(6);
  EXPECT_EQ(documents_->past("task", 256)->edits.size(), 6U);
  EXPECT_EQ(documents_->past("task", 4)->edits.size(), 4U);
  EXPECT_EQ(documents_->past("task", 4)->edits.front().edit.request, "t-2");
  documents_->put("task", kTask).value();
  EXPECT_EQ(documents_->past("task", 256)->edits.size(), 0U);
  documents_->put("task", kWithIds).value();
  edit(1);
  const RevisionText next = next_of(*documents_, set_doc("b", "after"));
  execute("UPDATE revision_edit SET request = 'x' WHERE number = " + std::to_string(next.revision.number - 1));
  EXPECT_EQ(error_of(documents_->past("task", 256)).path, "task/revisions/" + std::to_string(next.revision.number - 1));
  ASSERT_TRUE(documents_->append_edit(next, {set_doc("b", "after")}));
  EXPECT_EQ(documents_->past("task", 256)->edits.size(), 0U) << "what was before the last edit cannot be read";
}

TEST_F(RevisionTexts, AreRefusedIfTheyAreNotTheNextOfTheDocument) {
  RevisionText next = next_of(*documents_, set_doc("a", "x"));
  const RevisionEdit edit{set_doc("a", "x"), ""};
  next.revision.number = 3;
  EXPECT_EQ(documents_->append_edit(next, edit).error().code, ErrorCode::conflict);
  next.revision.number = 2;
  next.revision.change.author = std::string(Documents::kMaxAuthor + 1, 'x');
  EXPECT_EQ(documents_->append_edit(next, edit).error().code, ErrorCode::too_large);
  next.revision.change.author.pop_back();
  EXPECT_TRUE(documents_->append_edit(next, edit));
  EXPECT_EQ(documents_->append_edit(next, edit).error().code, ErrorCode::conflict);
}

}  // namespace
}  // namespace race::server
