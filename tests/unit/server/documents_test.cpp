// The store of documents: what is stored has ids, which the next revision keeps.
#include "server/store/documents.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/value/json.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTask = R"({"rcm": 1, "root": {"state": "R", "children": [{"state": "A"}, {"state": "B"}]}})";

class DocumentStore : public testing::Test {
 protected:
  DocumentStore() { fs::create_directories(folder_); }
  ~DocumentStore() override { fs::remove_all(folder_); }

  std::string path() const { return folder_ / "documents.sqlite"; }
  std::unique_ptr<Documents> open() const { return Documents::open(path()).value(); }

  /// A file as a version of the program without ids left it, with one document, `old`.
  void store_as_before(const std::string& text) const {
    SQLite::Database file(path(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    file.exec("CREATE TABLE document (name TEXT PRIMARY KEY, revision INTEGER NOT NULL, text TEXT NOT NULL)");
    SQLite::Statement insert(file, "INSERT INTO document VALUES ('old', 3, ?)");
    insert.bind(1, text);
    insert.exec();
  }
  std::string stored_text(const std::string& name) const {
    SQLite::Database file(path(), SQLite::OPEN_READONLY);
    SQLite::Statement select(file, "SELECT text FROM document WHERE name = ?");
    select.bind(1, name);
    return select.executeStep() ? select.getColumn(0).getString() : "";
  }

  const fs::path folder_ = fs::temp_directory_path() / ("race_documents_" + std::to_string(::getpid()));
};

std::string id_of(const StoredDocument& stored, std::size_t child) {
  return std::get<rcm::State>(stored.document.root.children.at(child)).meta.id;
}

TEST_F(DocumentStore, GivesIds) {
  const auto documents = open();
  const StoredDocument put = documents->put("task", kTask).value();
  EXPECT_FALSE(id_of(put, 0).empty());
  EXPECT_EQ(documents->get("task")->document, put.document);
  EXPECT_EQ(documents->list()->at(0).document, put.document);
}

TEST_F(DocumentStore, KeepsTheRevisionOfTheSameDocumentWithAndWithoutIds) {
  const auto documents = open();
  const StoredDocument put = documents->put("task", kTask).value();
  EXPECT_EQ(documents->put("task", kTask)->revision, 1);
  EXPECT_EQ(documents->put("task", rcm::format_document(put.document))->revision, 1);
  EXPECT_EQ(documents->get("task")->document, put.document);
}

TEST_F(DocumentStore, KeepsTheIdOfARenamedElementAndRestoresThoseThatAreMissing) {
  const auto documents = open();
  StoredDocument before = documents->put("task", kTask).value();
  auto& renamed = std::get<rcm::State>(before.document.root.children[0]);
  renamed.name = "C";
  auto& bare = std::get<rcm::State>(before.document.root.children[1]);
  const std::string id = std::exchange(bare.meta.id, "");
  const StoredDocument after = documents->put("task", rcm::format_document(before.document)).value();
  EXPECT_EQ(after.revision, 2);
  EXPECT_EQ(id_of(after, 0), renamed.meta.id);
  EXPECT_EQ(id_of(after, 1), id);
  const StoredDocument again =
      documents
          ->put("task",
                R"({"rcm": 1, "root": {"state": "R", "children": [{"state": "C", "doc": "d"}, {"state": "A"}]}})")
          .value();
  EXPECT_EQ(id_of(again, 0), renamed.meta.id) << "it stands where it stood";
  EXPECT_NE(id_of(again, 1), renamed.meta.id);
}

TEST_F(DocumentStore, GivesIdsToWhatAnOlderVersionStored) {
  store_as_before(kTask);
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("INSERT INTO document VALUES ('invalid', 1, '{}')");
  const StoredDocument first = open()->get("old").value();
  EXPECT_EQ(first.revision, 3) << "nobody changed it";
  EXPECT_FALSE(id_of(first, 0).empty());
  const auto documents = open();
  EXPECT_EQ(documents->get("old")->document, first.document);
  EXPECT_EQ(documents->put("old", kTask)->revision, 3);
  EXPECT_EQ(documents->list()->size(), 1U) << "what is invalid now stays in the file and is left out";
}

TEST_F(DocumentStore, PutsTheDemoWithIdsUntilSomebodyChangesIt) {
  std::ofstream(folder_ / "task.rcm.json") << kTask;
  const auto documents = open();
  ASSERT_TRUE(documents->put_demo(folder_));
  const StoredDocument first = documents->get("task").value();
  EXPECT_FALSE(id_of(first, 0).empty());
  ASSERT_TRUE(documents->put_demo(folder_));
  EXPECT_EQ(documents->get("task")->document, first.document);
  documents->put("task", R"({"rcm": 1, "root": {"state": "Mine"}})").value();
  ASSERT_TRUE(documents->put_demo(folder_));
  EXPECT_EQ(documents->get("task")->document.root.name, "Mine");
}

TEST_F(DocumentStore, GivesOneOfTwoElementsWithTheSameIdANewOne) {
  const auto documents = open();
  documents->put("task", R"({"rcm": 1, "root": {"state": "R", "children": [{"state": "A", "meta": {"id": "a"}}]}})")
      .value();
  const StoredDocument put = documents
                                 ->put("task", R"({"rcm": 1, "root": {"state": "R", "children": [
      {"state": "Copy", "meta": {"id": "a"}}, {"state": "A", "meta": {"id": "a"}}]}})")
                                 .value();
  EXPECT_EQ(id_of(put, 1), "a") << "it stands where it stood";
  EXPECT_NE(id_of(put, 0), "a");
  EXPECT_FALSE(id_of(put, 0).empty());
}

TEST_F(DocumentStore, ReplacesThePathsOfALayout) {
  const auto documents = open();
  const StoredDocument put = documents
                                 ->put("task", R"({"rcm": 1, "layout": {"R/A": {"x": 1}},
      "root": {"state": "R", "children": [{"state": "A"}]}})")
                                 .value();
  EXPECT_EQ(put.document.layout, Value(Dict{{id_of(put, 0), Dict{{"x", 1}}}}));
  EXPECT_EQ(documents->get("task")->document, put.document);
}

TEST_F(DocumentStore, GivesAnIdInPlaceOfOneThatAnOlderVersionTook) {
  store_as_before(R"({"rcm": 1, "root": {"state": "R", "meta": {"id": "a b", "icon": "x"},
      "children": [{"state": "A", "meta": {"id": 7}}, {"state": "B", "meta": {"id": "b"}}]}})");
  const StoredDocument old = open()->get("old").value();
  EXPECT_EQ(old.revision, 3);
  EXPECT_TRUE(rcm::is_id(old.document.root.meta.id));
  EXPECT_EQ(old.document.root.meta.rest, Value(Dict{{"icon", "x"}}));
  EXPECT_TRUE(rcm::is_id(id_of(old, 0)));
  EXPECT_EQ(id_of(old, 1), "b");
}

TEST_F(DocumentStore, LeavesADocumentWithABadIdAndOtherViolations) {
  for (const char* wrong : {R"("more": 1)", R"("first": "Nobody")"}) {
    fs::remove(path());
    const std::string text = R"({"rcm": 1, "root": {"state": "R", "meta": {"id": 7}, )" + std::string(wrong) + "}}";
    store_as_before(text);
    EXPECT_EQ(open()->get("old").error().size(), 2U) << "which say what is wrong";
    EXPECT_EQ(stored_text("old"), text);
  }
}

TEST_F(DocumentStore, ReadsTheDocumentsOfAnOlderVersionOnce) {
  store_as_before(kTask);
  open();
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("UPDATE document SET text = '" + std::string(kTask) + "'");
  open();
  EXPECT_EQ(stored_text("old"), kTask);
  SQLite::Database file(path(), SQLite::OPEN_READONLY);
  EXPECT_EQ(file.execAndGet("PRAGMA user_version").getInt(), 1);
}

TEST_F(DocumentStore, KeepsTheIdsOfAStoredRevisionThatHasViolations) {
  const auto documents = open();
  SQLite::Database(path(), SQLite::OPEN_READWRITE)
      .exec(R"sql(INSERT INTO document VALUES ('task', 1, '{"rcm": 1, "root": {"state": "R", "first": "Nobody",
               "children": [{"state": "A", "meta": {"id": "a"}}, {"state": "B", "meta": {"id": "b"}}]}}'))sql");
  const StoredDocument put = documents->put("task", kTask).value();
  EXPECT_EQ(put.revision, 2);
  EXPECT_EQ(id_of(put, 0), "a");
  EXPECT_EQ(id_of(put, 1), "b");
}

/// A document that is so deep that its root gets no id: no object becomes one, which is a level more.
std::string deepest() {
  const std::size_t lists = JsonLimits{}.depth - 2;
  return R"({"rcm": 1, "root": {"state": "R", "meta": )" + std::string(lists, '[') + std::string(lists, ']') + "}}";
}

/// One that is too long with ids.
std::string largest() {
  const std::string start = R"({"rcm": 1, "root": {"state": "R", "doc": ")", end = "\"}}";
  return start + std::string(JsonLimits{}.bytes - start.size() - end.size(), 'x') + end;
}

TEST_F(DocumentStore, RefusesWhatCouldNotBeReadAgainAndKeepsWhatItHas) {
  const auto documents = open();
  const StoredDocument before = documents->put("task", kTask).value();
  for (const auto& [text, code] :
       {std::pair(deepest(), ErrorCode::too_deep), std::pair(largest(), ErrorCode::too_large)}) {
    ASSERT_TRUE(rcm::read_document_text(text));
    const auto put = documents->put("task", text);
    ASSERT_FALSE(put);
    EXPECT_EQ(put.error().front().code, code);
    EXPECT_EQ(documents->get("task").value().document, before.document);
    EXPECT_EQ(documents->get("task").value().revision, 1);
  }
}

TEST_F(DocumentStore, LeavesWhatAnOlderVersionStoredIfItCouldNotBeReadAgain) {
  store_as_before(deepest());
  EXPECT_EQ(open()->get("old").value().document.root.name, "R");
  EXPECT_EQ(stored_text("old"), deepest());
}

TEST_F(DocumentStore, NamesTheFileOfADemoThatCouldNotBeReadAgain) {
  std::ofstream(folder_ / "task.rcm.json") << deepest();
  const auto put = open()->put_demo(folder_);
  ASSERT_FALSE(put);
  EXPECT_EQ(put.error().front().code, ErrorCode::too_deep);
  EXPECT_NE(put.error().front().path.find("task.rcm.json"), std::string::npos);
}

}  // namespace
}  // namespace race::server
