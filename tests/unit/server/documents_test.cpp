// The store of documents: what is stored has ids, which the next revision keeps.
#include "server/store/documents.h"

#include <fstream>

#include "core/rcm/ids.h"
#include "core/value/json.h"
#include "tests/unit/server/document_store.h"

namespace race::server {
namespace {

TEST_F(DocumentStore, GivesIds) {
  const auto documents = open();
  const rcm::Document put = document_of(documents->put("task", kTask));
  EXPECT_FALSE(id_of(put, 0).empty());
  EXPECT_EQ(documents->get("task")->document, put);
  EXPECT_EQ(document_of(documents->entry("task")), put);
}

TEST_F(DocumentStore, KeepsTheRevisionOfTheSameDocumentWithAndWithoutIds) {
  const auto documents = open();
  const rcm::Document put = document_of(documents->put("task", kTask));
  EXPECT_EQ(documents->put("task", kTask)->revision.number, 1);
  EXPECT_EQ(documents->put("task", rcm::format_document(put))->revision.number, 1);
  EXPECT_EQ(documents->get("task")->document, put);
  EXPECT_EQ(documents->revisions("task", {}, 100)->size(), 1U);
}

TEST_F(DocumentStore, KeepsTheIdOfARenamedElementAndRestoresThoseThatAreMissing) {
  const auto documents = open();
  rcm::Document before = document_of(documents->put("task", kTask));
  auto& renamed = std::get<rcm::State>(before.root.children[0]);
  renamed.name = "C";
  auto& bare = std::get<rcm::State>(before.root.children[1]);
  const std::string id = std::exchange(bare.meta.id, "");
  const auto after = documents->put("task", rcm::format_document(before));
  EXPECT_EQ(after->revision.number, 2);
  EXPECT_EQ(id_of(document_of(after), 0), renamed.meta.id);
  EXPECT_EQ(id_of(document_of(after), 1), id);
  const auto again = documents->put(
      "task", R"({"rcm": 1, "root": {"state": "R", "children": [{"state": "C", "doc": "d"}, {"state": "A"}]}})");
  EXPECT_EQ(id_of(document_of(again), 0), renamed.meta.id) << "it stands where it stood";
  EXPECT_NE(id_of(document_of(again), 1), renamed.meta.id);
}

TEST_F(DocumentStore, GivesOneOfTwoElementsWithTheSameIdANewOne) {
  const auto documents = open();
  documents->put("task", R"({"rcm": 1, "root": {"state": "R", "children": [{"state": "A", "meta": {"id": "a"}}]}})")
      .value();
  const rcm::Document put = document_of(documents->put("task", R"({"rcm": 1, "root": {"state": "R", "children": [
      {"state": "Copy", "meta": {"id": "a"}}, {"state": "A", "meta": {"id": "a"}}]}})"));
  EXPECT_EQ(id_of(put, 1), "a") << "it stands where it stood";
  EXPECT_NE(id_of(put, 0), "a");
  EXPECT_FALSE(id_of(put, 0).empty());
}

TEST_F(DocumentStore, ReplacesThePathsOfALayout) {
  const auto documents = open();
  const rcm::Document put = document_of(documents->put("task", R"({"rcm": 1, "layout": {"R/A": {"x": 1}},
      "root": {"state": "R", "children": [{"state": "A"}]}})"));
  EXPECT_EQ(put.layout, Value(Dict{{id_of(put, 0), Dict{{"x", 1}}}}));
  EXPECT_EQ(documents->get("task")->document, put);
}

TEST_F(DocumentStore, PutsTheDemoWithIdsUntilSomebodyChangesIt) {
  const auto write = [this](const char* text) { std::ofstream(folder_ / "task.rcm.json") << text; };
  write(kTask);
  const auto documents = open();
  ASSERT_TRUE(documents->put_demo(folder_, 7));
  const auto first = documents->entry("task").value();
  EXPECT_FALSE(id_of(documents->get("task")->document, 0).empty());
  EXPECT_EQ(first.revision, (Revision{"task", 1, {"", "", 7}, {Origin::Kind::demo}, 0, ""}));
  ASSERT_TRUE(documents->put_demo(folder_, 8));
  EXPECT_EQ(documents->entry("task")->revision, first.revision);
  write(R"({"rcm": 1, "root": {"state": "New"}})");
  ASSERT_TRUE(documents->put_demo(folder_, 9));
  EXPECT_EQ(documents->entry("task")->revision.number, 2) << "the demo of a newer program";
  EXPECT_EQ(documents->get("task")->document.root.name, "New");
  documents->put("task", R"({"rcm": 1, "root": {"state": "Mine"}})").value();
  write(kTask);
  ASSERT_TRUE(documents->put_demo(folder_, 10));
  EXPECT_EQ(documents->get("task")->document.root.name, "Mine");
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
  const auto before = documents->put("task", kTask).value();
  for (const auto& [text, code] :
       {std::pair(deepest(), ErrorCode::too_deep), std::pair(largest(), ErrorCode::too_large)}) {
    ASSERT_TRUE(rcm::read_document_text(text));
    const auto put = documents->put("task", text);
    ASSERT_FALSE(put);
    EXPECT_EQ(error_of(put).code, code);
    EXPECT_EQ(documents->entry("task")->document, before.document);
    EXPECT_EQ(documents->entry("task")->revision, before.revision);
  }
}

TEST_F(DocumentStore, NamesTheFileOfADemoThatCouldNotBeReadAgain) {
  std::ofstream(folder_ / "task.rcm.json") << deepest();
  const auto put = open()->put_demo(folder_, 0);
  ASSERT_FALSE(put);
  EXPECT_EQ(put.error().front().code, ErrorCode::too_deep);
  EXPECT_NE(put.error().front().path.find("task.rcm.json"), std::string::npos);
}

TEST_F(DocumentStore, ListsTheBeginningOfTheDocOfTheRoot) {
  std::string doc;
  for (int i = 0; i < 1001; ++i) doc += "ä";
  const auto documents = open();
  documents->put("task", R"({"rcm": 1, "root": {"state": "R", "doc": ")" + doc + "\"}}").value();
  EXPECT_EQ(documents->list()->at(0).doc, doc.substr(0, 2000)) << "1000 characters of two bytes";
}

}  // namespace
}  // namespace race::server
