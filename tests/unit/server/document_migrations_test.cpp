// What older versions of the program stored: it gets ids and is the first revision, with the number that it had.
#include "server/store/document_migrations.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "core/rcm/ids.h"
#include "core/value/json.h"
#include "server/store/data_folder.h"
#include "tests/unit/server/document_store.h"

namespace race::server {
namespace {

class OldDocuments : public DocumentStore {
 protected:
  /// A file as a version of the program without revisions left it, with one document, `old`, in revision 3.
  static void store_as_before(const std::string& path, const std::string& text, int version = 0) {
    SQLite::Database file(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    file.exec("CREATE TABLE document (name TEXT PRIMARY KEY, revision INTEGER NOT NULL, text TEXT NOT NULL)");
    file.exec("PRAGMA user_version = " + std::to_string(version));
    SQLite::Statement insert(file, "INSERT INTO document VALUES ('old', 3, ?)");
    insert.bind(1, text);
    insert.exec();
  }
  void store_as_before(const std::string& text) const { store_as_before(path(), text); }
  std::string stored_text(const std::string& name) const {
    SQLite::Database file(path(), SQLite::OPEN_READONLY);
    SQLite::Statement select(file, "SELECT text FROM revision WHERE document = ? ORDER BY number DESC");
    select.bind(1, name);
    return select.executeStep() ? select.getColumn(0).getString() : "";
  }
};

TEST_F(OldDocuments, GetIdsAndKeepTheirRevisionAsTheFirstOne) {
  store_as_before(kTask);
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("INSERT INTO document VALUES ('invalid', 1, '{}')");
  const rcm::Document first = open()->get("old")->document;
  EXPECT_FALSE(id_of(first, 0).empty());
  const auto documents = open();
  EXPECT_EQ(documents->get("old")->document, first);
  EXPECT_EQ(documents->put("old", kTask)->revision.number, 3) << "nobody changed it";
  EXPECT_EQ(documents->list().value(), (std::vector<Revision>{{"invalid", 1, {}, {Origin::Kind::older}, 2, ""},
                                                              {"old", 3, {}, {Origin::Kind::older}, 0, ""}}));
  EXPECT_EQ(documents->put("old", R"({"rcm": 1, "root": {"state": "R"}})")->revision.number, 4);
  EXPECT_EQ(documents->revisions("old", {}, 100)->size(), 2U);
  EXPECT_EQ(error_of(documents->entry("old", 2)).code, ErrorCode::not_found);
}

TEST_F(OldDocuments, AreTakenOverFromAFileOfTheirOwn) {
  store_as_before(folder_ / "documents.sqlite", kTask);
  const DataFolder folder = DataFolder::open(folder_).value();
  const auto documents = Documents::open(folder.store()).value();
  EXPECT_EQ(documents->get("old")->revision, 3);
  EXPECT_FALSE(id_of(documents->get("old")->document, 0).empty());
}

TEST_F(OldDocuments, GetAnIdInPlaceOfOneThatWasTaken) {
  store_as_before(R"({"rcm": 1, "root": {"state": "R", "meta": {"id": "a b", "icon": "x"},
      "children": [{"state": "A", "meta": {"id": 7}}, {"state": "B", "meta": {"id": "b"}}]}})");
  const StoredDocument old = open()->get("old").value();
  EXPECT_EQ(old.revision, 3);
  EXPECT_TRUE(rcm::is_id(old.document.root.meta.id));
  EXPECT_EQ(old.document.root.meta.rest, Value(Dict{{"icon", "x"}}));
  EXPECT_TRUE(rcm::is_id(id_of(old.document, 0)));
  EXPECT_EQ(id_of(old.document, 1), "b");
}

TEST_F(OldDocuments, AreDraftsWithABadIdAndOtherViolations) {
  for (const char* wrong : {R"("more": 1)", R"("first": "Nobody")"}) {
    std::filesystem::remove(path());
    const std::string text = R"({"rcm": 1, "root": {"state": "R", "meta": {"id": 7}, )" + std::string(wrong) + "}}";
    store_as_before(text);
    const auto documents = open();
    EXPECT_EQ(documents->get("old").error().size(), 2U) << "which say what is wrong";
    EXPECT_EQ(documents->entry("old")->errors, documents->get("old").error());
    EXPECT_EQ(documents->entry("old")->revision.errors, 2);
    EXPECT_EQ(stored_text("old"), text);
  }
}

TEST_F(OldDocuments, AreGivenIdsOnce) {
  store_as_before(path(), kTask, 1);
  open();
  EXPECT_EQ(stored_text("old"), kTask) << "a version that gives ids stored it";
}

TEST_F(OldDocuments, StayIfTheyCouldNotBeReadAgain) {
  const std::size_t lists = JsonLimits{}.depth - 2;
  const std::string deepest =
      R"({"rcm": 1, "root": {"state": "R", "meta": )" + std::string(lists, '[') + std::string(lists, ']') + "}}";
  store_as_before(deepest);
  EXPECT_EQ(open()->get("old")->document.root.name, "R");
  EXPECT_EQ(stored_text("old"), deepest);
}

TEST_F(OldDocuments, StayIfTheyAreNoJson) {
  store_as_before("{");
  const auto documents = open();
  EXPECT_EQ(stored_text("old"), "{");
  EXPECT_EQ(error_of(documents->entry("old")).code, ErrorCode::json);
  EXPECT_EQ(error_of(documents->restore("old", 3, {})).code, ErrorCode::json);
  EXPECT_EQ(error_of(documents->branch("old", {"new", {}}, {})).code, ErrorCode::json);
  EXPECT_EQ(documents->list()->size(), 1U);
  EXPECT_EQ(documents->put("old", kTask)->revision.number, 4);
  EXPECT_EQ(error_of(documents->restore("old", 3, {})).code, ErrorCode::json);
  EXPECT_EQ(documents->get("old")->revision, 4);
}

}  // namespace
}  // namespace race::server
