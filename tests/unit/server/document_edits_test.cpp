// Revisions that edits have made: stored as edits or whole, read as they were, damage named.
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "core/edit/apply.h"
#include "tests/unit/server/document_store.h"

namespace race::server {
namespace {

class DocumentEdits : public DocumentStore {
 protected:
  /// Stores the document `task` and then `count` edits of its first child's `doc`.
  void make(std::int64_t count, std::size_t doc_size = 1) {
    documents_ = open();
    document_ = document_of(documents_->put("task", kTask, {"Ada", "begin", 1}));
    for (std::int64_t i = 1; i <= count; ++i)
      ASSERT_TRUE(edit("edit " + std::to_string(i) + std::string(doc_size, 'x')));
  }
  Expected<void> edit(const std::string& doc, std::optional<std::int64_t> number = {}) {
    const edit::Edit edit{{edit::Set{id_of(document_, 0), "doc", {}, Value(doc)}}};
    auto applied = edit::apply(document_, edit).value();
    const std::int64_t last = documents_->entry("task")->revision.number;
    Revision next{"task", number.value_or(last + 1), {"Bob", doc.substr(0, 6), 2}, {Origin::Kind::edit}, 0, ""};
    auto stored = documents_->append_edit({next, rcm::write_document_text(applied.document).value()},
                                          {edit, "token" + std::to_string(last + 1)});
    if (stored) document_ = std::move(applied.document);
    return stored;
  }
  void execute(const std::string& sql) const { SQLite::Database(path(), SQLite::OPEN_READWRITE).exec(sql); }
  std::int64_t number(const std::string& sql) const { return SQLite::Database(path()).execAndGet(sql).getInt64(); }
  std::string doc(std::int64_t revision) const {
    const auto document = document_of(documents_->entry("task", revision));
    return std::get<rcm::State>(document.root.children.at(0)).doc;
  }
  void expect_corrupt(std::int64_t revision, const std::string& path) {
    const Error error = error_of(documents_->entry("task", revision));
    EXPECT_EQ(error.code, ErrorCode::corrupt);
    EXPECT_EQ(error.path, path) << "revision " << revision;
  }

  std::unique_ptr<Documents> documents_;
  rcm::Document document_;
};

TEST_F(DocumentEdits, AreRevisionsThatCanBeRead) {
  make(3);
  documents_ = open();
  for (std::int64_t i = 1; i <= 3; ++i) EXPECT_EQ(doc(i + 1), "edit " + std::to_string(i) + "x");
  const auto revisions = documents_->revisions("task", {}, 100).value();
  ASSERT_EQ(revisions.size(), 4U);
  EXPECT_EQ(revisions[0].origin.kind, Origin::Kind::edit);
  EXPECT_EQ(revisions[0].change, (Change{"Bob", "edit 3", 2}));
  EXPECT_EQ(documents_->edit_of("task", 3)->request, "token3");
}

TEST_F(DocumentEdits, KeepAWholeTextAtLeastEvery32Revisions) {
  make(70);
  EXPECT_EQ(number("SELECT count(*) FROM revision WHERE text <> ''"), 3) << "revisions 1, 33, 65";
  EXPECT_EQ(number("SELECT max(depth) FROM revision_edit"), kLongestChain);
  for (const std::int64_t i : {32, 33, 34, 64, 65, 71}) EXPECT_EQ(doc(i), "edit " + std::to_string(i - 1) + "x");
}

TEST_F(DocumentEdits, AreStoredWholeWhereThatIsShorter) {
  make(2, 1000);
  EXPECT_EQ(number("SELECT count(*) FROM revision WHERE text = ''"), 2);
  const std::string id = document_.root.meta.id;
  edit::Edit edit;
  for (int i = 0; i < 100; ++i) edit.operations.push_back(edit::Set{id, "doc", {}, Value(std::string(100, 'y'))});
  const auto applied = edit::apply(document_, edit).value();
  ASSERT_TRUE(documents_->append_edit(
      {{"task", 4, {}, {Origin::Kind::edit}, 0, ""}, rcm::write_document_text(applied.document).value()}, {edit}));
  EXPECT_EQ(number("SELECT depth FROM revision_edit WHERE number = 4"), 0);
  EXPECT_EQ(documents_->edit_of("task", 4)->edit, edit);
}

TEST_F(DocumentEdits, FollowTheLastRevisionAlone) {
  make(1);
  for (const std::int64_t number : {1, 2, 4}) EXPECT_EQ(edit("x", number).error().code, ErrorCode::conflict);
  EXPECT_EQ(documents_->entry("task")->revision.number, 2);
}

TEST_F(DocumentEdits, CanBeRestoredBranchedAndPutOver) {
  make(3);
  ASSERT_TRUE(documents_->restore("task", 3, {"Ada", "", 5}));
  EXPECT_EQ(doc(5), "edit 2x");
  ASSERT_TRUE(documents_->branch("task", {"mine", 2}, {"Ada", "", 6}));
  EXPECT_EQ(documents_->entry("mine")->document, documents_->entry("task", 2)->document);
  ASSERT_TRUE(documents_->put("task", kTask, {"Ada", "", 7}));
  document_ = document_of(documents_->entry("task"));
  ASSERT_TRUE(edit("again"));
  EXPECT_EQ(doc(7), "again");
}

TEST_F(DocumentEdits, ReachBackToTheLastOtherRevision) {
  make(3);
  const auto past = documents_->past("task", 100).value();
  ASSERT_EQ(past.edits.size(), 3U);
  EXPECT_EQ(past.edits[0].revision.number, 2);
  EXPECT_EQ(past.last.revision.number, 4);
  EXPECT_EQ(documents_->past("task", 2)->edits.size(), 2U);
  ASSERT_TRUE(documents_->restore("task", 2, {}));
  EXPECT_TRUE(documents_->past("task", 100)->edits.empty());
}

TEST_F(DocumentEdits, NameTheDamagedLinkForAllThatAreBuiltOnIt) {
  make(5);
  for (const char* damage : {"UPDATE revision_edit SET edit = edit || ' ' WHERE number = 3",
                             "UPDATE revision_edit SET depth = 1 WHERE number = 3",
                             "UPDATE revision_edit SET request = 'x' WHERE number = 3",
                             "UPDATE revision_edit SET digest = zeroblob(32) WHERE number = 3",
                             "DELETE FROM revision_edit WHERE number = 3"}) {
    SCOPED_TRACE(damage);
    documents_.reset();
    const auto before = std::filesystem::path(path() + ".before");
    std::filesystem::copy_file(path(), before, std::filesystem::copy_options::overwrite_existing);
    execute(damage);
    documents_ = Documents::open(path()).value();
    EXPECT_EQ(doc(2), "edit 1x") << "what is before it can be read";
    for (const std::int64_t revision : {3, 4, 6}) expect_corrupt(revision, "task/revisions/3");
    EXPECT_TRUE(documents_->list()) << "lists read no texts";
    documents_.reset();
    std::filesystem::copy_file(before, path(), std::filesystem::copy_options::overwrite_existing);
  }
}

TEST_F(DocumentEdits, NameTheDamagedTextThatTheyAreBuiltOn) {
  make(2);
  execute("UPDATE revision SET text = text || ' ' WHERE number = 1");
  for (const std::int64_t revision : {1, 2, 3}) expect_corrupt(revision, "task/revisions/1");
}

TEST_F(DocumentEdits, OfAnotherTextAreNamed) {
  make(2);
  execute("UPDATE revision SET text = '' WHERE number = 1");
  for (const std::int64_t revision : {1, 2, 3}) expect_corrupt(revision, "task/revisions/1");
}

}  // namespace
}  // namespace race::server
