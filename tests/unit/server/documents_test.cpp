// The store of documents: what is stored has ids, which the next revision keeps.
#include "server/store/documents.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/rcm/document.h"

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
  {
    open();
    SQLite::Database file(path(), SQLite::OPEN_READWRITE);
    SQLite::Statement insert(file, "INSERT INTO document VALUES ('old', 3, ?), ('invalid', 1, '{}')");
    insert.bind(1, kTask);
    insert.exec();
  }
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

}  // namespace
}  // namespace race::server
