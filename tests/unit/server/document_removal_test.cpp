// Removal of documents: with all revisions, in short transactions; a document of the same name goes on after the last.
#include "server/store/document_removal.h"

#include <fstream>

#include "server/store/documents.h"
#include "tests/unit/server/document_store.h"

namespace race::server {
namespace {

class DocumentRemoval : public DocumentStore {
 protected:
  /// `count` revisions.
  static void put(Documents& documents, const std::string& name, int count) {
    documents.put(name, kTask).value();
    for (int i = 1; i < count; ++i) edit_doc(documents, name, std::to_string(i), {}).value();
  }
  std::int64_t rows(const std::string& of) const {
    const auto file = sqlite::open(path());
    return file->execAndGet("SELECT count(*) FROM " + of).getInt64();
  }
  void change(const std::string& statement) const { sqlite::open(path())->exec(statement); }
};

TEST_F(DocumentRemoval, LeavesNothingOfItAndTheOthersAsTheyAre) {
  const auto documents = open();
  put(*documents, "task", 3);
  put(*documents, "tasks", 2);
  ASSERT_TRUE(documents->remove("task"));
  EXPECT_EQ(error_of(documents->entry("task")).code, ErrorCode::not_found);
  EXPECT_EQ(error_of(documents->entry("task", 2)).code, ErrorCode::not_found);
  EXPECT_EQ(documents->remove("task").error().code, ErrorCode::not_found);
  EXPECT_EQ(documents->list()->size(), 1U);
  EXPECT_EQ(documents->entry("tasks", 2)->revision.number, 2);
  EXPECT_EQ(rows("revision WHERE document = 'task'") + rows("revision_edit WHERE document = 'task'"), 0);
}

TEST_F(DocumentRemoval, LetsADocumentOfTheSameNameGoOnAfterItsLastRevision) {
  auto documents = open();
  put(*documents, "task", 3);
  ASSERT_TRUE(documents->remove("task"));
  documents = open();
  const auto put_again = documents->put("task", kTask).value();
  EXPECT_EQ(put_again.revision.number, 4);
  EXPECT_TRUE(put_again.is_new);
  EXPECT_EQ(edit_doc(*documents, "task", "more", {})->revision.number, 5);
  EXPECT_EQ(documents->revisions("task", {}, 100)->size(), 2U);
  EXPECT_EQ(error_of(documents->entry("task", 3)).code, ErrorCode::not_found);
  ASSERT_TRUE(documents->remove("task"));
  EXPECT_EQ(documents->branch("other", {"task", {}}, {}).error().front().code, ErrorCode::not_found);
  put(*documents, "other", 1);
  EXPECT_EQ(documents->branch("other", {"task", {}}, {})->revision.number, 6);
}

TEST_F(DocumentRemoval, ForgetsTheTokensOfItsEdits) {
  const auto documents = open();
  put(*documents, "task", 1);
  const auto next = documents->entry("task").value();
  Revision revision = next.revision;
  revision.number = 2;
  revision.origin = {Origin::Kind::edit};
  ASSERT_TRUE(documents->append_edit(
      {revision, rcm::write_document_text(document_of(documents->entry("task"))).value()}, {{}, "token"}));
  ASSERT_EQ(documents->tokens("task", 10)->size(), 1U);
  ASSERT_TRUE(documents->remove("task"));
  put(*documents, "task", 1);
  EXPECT_TRUE(documents->tokens("task", 10)->empty());
}

TEST_F(DocumentRemoval, IsRefusedIfSomebodyHasChangedIt) {
  const auto documents = open();
  put(*documents, "task", 2);
  EXPECT_EQ(documents->remove("task", 1).error().code, ErrorCode::conflict);
  EXPECT_TRUE(documents->entry("task"));
  EXPECT_TRUE(documents->remove("task", 2));
}

TEST_F(DocumentRemoval, IsFinishedWhenTheStoreIsOpened) {
  auto documents = open();
  const int count = static_cast<int>(kRevisionsAtOnce) + 3;
  put(*documents, "task", count);
  put(*documents, "other", 2);
  documents.reset();
  {
    const auto file = sqlite::open(path());
    begin_removal(*file, "task", count);
    EXPECT_TRUE(remove_some(*file, "task"));
    EXPECT_EQ(rows("revision WHERE document = 'task'"), 3);
    EXPECT_TRUE(list_heads(*file, "", 10).damaged.empty());
  }
  documents = open();
  EXPECT_EQ(rows("revision WHERE document = 'task'") + rows("revision_edit WHERE document = 'task'"), 0);
  EXPECT_EQ(documents->heads()->damaged.size(), 0U);
  EXPECT_EQ(documents->entry("other")->revision.number, 2);
  EXPECT_EQ(documents->put("task", kTask)->revision.number, count + 1);
}

TEST_F(DocumentRemoval, TakesManyRevisionsPieceByPiece) {
  const auto documents = open();
  put(*documents, "task", 2 * static_cast<int>(kRevisionsAtOnce) + 3);
  ASSERT_TRUE(documents->remove("task"));
  EXPECT_EQ(rows("revision") + rows("revision_edit"), 0);
}

TEST_F(DocumentRemoval, LeavesTheDamageOfALaterDocumentOfTheNameNamed) {
  const auto documents = open();
  put(*documents, "task", 2);
  ASSERT_TRUE(documents->remove("task"));
  put(*documents, "task", 1);
  change("UPDATE removed_document SET last = 1");
  EXPECT_TRUE(edit_doc(*documents, "task", "more", {})) << "the number of the document says what is next";
  change("DELETE FROM document");
  EXPECT_EQ(documents->heads()->damaged.size(), 1U);
}

TEST_F(DocumentRemoval, TakesADamagedDocumentToo) {
  const auto documents = open();
  put(*documents, "task", 3);
  change("UPDATE document SET first = 2 WHERE name = 'task'");
  ASSERT_EQ(error_of(documents->entry("task")).code, ErrorCode::corrupt);
  EXPECT_EQ(documents->remove("task", 3).error().code, ErrorCode::corrupt) << "which revision it has is not known";
  ASSERT_TRUE(documents->remove("task"));
  EXPECT_TRUE(documents->heads()->damaged.empty());
  EXPECT_EQ(documents->put("task", kTask)->revision.number, 4);
}

TEST_F(DocumentRemoval, NamesWhatIsDamagedOfIt) {
  const auto documents = open();
  put(*documents, "task", 3);
  ASSERT_TRUE(documents->remove("task"));
  change("UPDATE removed_document SET last = 1");
  EXPECT_EQ(error_of(documents->put("task", kTask)).code, ErrorCode::corrupt);
}

TEST_F(DocumentRemoval, KeepsSoManyNames) {
  const auto documents = open();
  put(*documents, "first", 2);
  ASSERT_TRUE(documents->remove("first"));
  change("UPDATE sqlite_sequence SET seq = " + std::to_string(kMostRemoved) + " WHERE name = 'removed_document'");
  put(*documents, "second", 2);
  ASSERT_TRUE(documents->remove("second"));
  EXPECT_EQ(rows("removed_document"), 1);
  EXPECT_EQ(documents->put("first", kTask)->revision.number, 1);
  EXPECT_EQ(documents->put("second", kTask)->revision.number, 3);
}

TEST_F(DocumentRemoval, OfADemoHoldsWhenTheServerBeginsAgain) {
  const auto demo = folder_ / "demo";
  std::filesystem::create_directory(demo);
  std::ofstream(demo / "task.rcm.json") << kTask;
  auto documents = open();
  ASSERT_TRUE(documents->put_demo(demo, 1));
  ASSERT_TRUE(documents->remove("task"));
  documents = open();
  ASSERT_TRUE(documents->put_demo(demo, 2));
  EXPECT_EQ(error_of(documents->entry("task")).code, ErrorCode::not_found);
}

TEST_F(DocumentRemoval, LeavesDocumentsListedByPages) {
  const auto documents = open();
  for (const char* name : {"a", "b", "c", "d", "e"}) put(*documents, name, 1);
  const auto names = [&](const std::string& after, std::int64_t most) {
    const DocumentHeads heads = documents->heads(after, most).value();
    std::string out;
    for (const Revision& each : heads.revisions) out += each.document;
    for (const Error& each : heads.damaged) out += "!" + each.path;
    return out + (heads.next.empty() ? "" : ">" + heads.next);
  };
  EXPECT_EQ(names("", 2), "ab>b");
  EXPECT_EQ(names("b", 2), "cd>d");
  EXPECT_EQ(names("d", 2), "e");
  EXPECT_EQ(names("", 5), "abcde");
  EXPECT_EQ(names("e", 5), "");
  ASSERT_TRUE(documents->remove("b"));
  change("DELETE FROM document WHERE name = 'd'");
  EXPECT_EQ(names("", 2), "ac>c");
  EXPECT_EQ(names("c", 2), "e!d");
}

}  // namespace
}  // namespace race::server
