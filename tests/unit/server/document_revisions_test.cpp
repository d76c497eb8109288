// Every revision of a document, drafts among them: who stored it and when; restored and branched.
#include <fstream>

#include "core/rcm/ids.h"
#include "core/value/json.h"
#include "server/store/documents.h"
#include "tests/unit/server/document_store.h"

namespace race::server {
namespace {

class DocumentRevisions : public DocumentStore {};

std::string task_of(const std::string& doc) { return R"({"rcm": 1, "root": {"state": "R", "doc": ")" + doc + "\"}}"; }

TEST_F(DocumentRevisions, KeepsEveryRevisionWithAuthorTimeAndMessage) {
  const auto documents = open();
  const auto first = documents->put("task", task_of("one"), {"Ada", "begin", 1000}).value();
  const auto second = documents->put("task", task_of("two"), {"Bob", "", 2000}).value();
  EXPECT_EQ(first.revision, (Revision{"task", 1, {"Ada", "begin", 1000}, {}, 0, "one"}));
  EXPECT_EQ(second.revision, (Revision{"task", 2, {"Bob", "", 2000}, {}, 0, "two"}));
  const auto again = open();
  EXPECT_EQ(again->revisions("task", {}, 100).value(), (std::vector{second.revision, first.revision}));
  EXPECT_EQ(again->entry("task", 1)->document, first.document);
  EXPECT_EQ(again->entry("task", 2)->document, second.document);
  EXPECT_EQ(again->entry("task")->document, second.document);
  EXPECT_EQ(again->list().value(), (std::vector{second.revision}));
}

TEST_F(DocumentRevisions, ListsRevisionsByPages) {
  const auto documents = open();
  for (int i = 1; i <= 5; ++i) documents->put("task", task_of(std::to_string(i))).value();
  const auto numbers = [&](std::optional<std::int64_t> before, std::int64_t most) {
    std::vector<std::int64_t> out;
    const auto found = documents->revisions("task", before, most).value();
    for (const Revision& each : found) out.push_back(each.number);
    return out;
  };
  using Numbers = std::vector<std::int64_t>;
  EXPECT_EQ(numbers({}, 2), (Numbers{5, 4}));
  EXPECT_EQ(numbers(4, 2), (Numbers{3, 2}));
  EXPECT_EQ(numbers(2, 2), (Numbers{1}));
  EXPECT_EQ(numbers(1, 2), Numbers{});
  EXPECT_EQ(numbers(100, 1), (Numbers{5}));
}

TEST_F(DocumentRevisions, NamesWhatIsNotThere) {
  const auto documents = open();
  documents->put("task", kTask).value();
  for (const Error& error :
       {error_of(documents->get("other")), error_of(documents->entry("other")), error_of(documents->entry("task", 2)),
        error_of(documents->entry("task", 0)), error_of(documents->revisions("other", {}, 1)),
        error_of(documents->restore("other", 1, {})), error_of(documents->restore("task", 2, {})),
        error_of(documents->branch("other", {"new", {}}, {})), error_of(documents->branch("task", {"new", 2}, {}))})
    EXPECT_EQ(error.code, ErrorCode::not_found);
}

TEST_F(DocumentRevisions, RefusesADraftUnlessItIsAskedFor) {
  const auto documents = open();
  EXPECT_EQ(error_of(documents->put("task", kDraft)).code, ErrorCode::first);
  EXPECT_EQ(error_of(documents->get("task")).code, ErrorCode::not_found);
  const auto put = documents->put("task", kDraft, {}, as_draft()).value();
  EXPECT_EQ(put.revision.errors, 1);
  EXPECT_EQ(put.errors.at(0).code, ErrorCode::first);
  EXPECT_EQ(documents->entry("task")->errors, put.errors);
  EXPECT_EQ(documents->list()->at(0).errors, 1);
  EXPECT_EQ(documents->get("task").error(), put.errors) << "it cannot be executed";
  EXPECT_EQ(documents->put("task", kTask, {}, as_draft())->errors.size(), 0U);
  EXPECT_EQ(documents->get("task")->revision, 2);
}

TEST_F(DocumentRevisions, GivesADraftIdsThatTheNextRevisionKeeps) {
  const auto documents = open();
  const rcm::Document before = document_of(documents->put("task", kTask));
  const auto draft = documents->put("task", kDraft, {}, as_draft()).value();
  const Value* children = draft.document.find("root")->find("children");
  EXPECT_EQ(children->as_list().at(0).find("meta")->find("id")->as_string(), id_of(before, 0));
  EXPECT_EQ(documents->entry("task")->document, draft.document);
  EXPECT_EQ(documents->put("task", kDraft, {}, as_draft())->revision.number, 2);
  EXPECT_EQ(id_of(document_of(documents->put("task", kTask)), 0), id_of(before, 0));
}

TEST_F(DocumentRevisions, KeepsADraftWhoseShapeIsWrongAsItCame) {
  const auto documents = open();
  const auto put = documents->put("task", kTornDraft, {}, as_draft()).value();
  EXPECT_EQ(put.document, parse_json(kTornDraft).value());
  EXPECT_GT(put.errors.size(), 1U);
  EXPECT_EQ(documents->entry("task")->document, put.document);
  EXPECT_EQ(documents->entry("task")->errors, put.errors);
  EXPECT_EQ(documents->put("task", kTornDraft, {}, as_draft())->revision.number, 1);
}

TEST_F(DocumentRevisions, RefusesADraftThatIsNoObjectOrHasANumberOutOfRange) {
  const auto documents = open();
  const auto code = [&](const char* text) { return error_of(documents->put("task", text, {}, as_draft())).code; };
  EXPECT_EQ(code("{"), ErrorCode::json);
  EXPECT_EQ(code("[]"), ErrorCode::type);
  EXPECT_EQ(code(R"({"rcm": 1, "root": {"state": "R", "variables": [{"name": "a", "initial": 9223372036854775808}]}})"),
            ErrorCode::constant);
  EXPECT_TRUE(documents->list()->empty());
}

TEST_F(DocumentRevisions, RestoresAnEarlierRevisionAsTheNextOne) {
  const auto documents = open();
  const auto first = documents->put("task", kDraft, {}, as_draft()).value();
  documents->put("task", kTask).value();
  const auto restored = documents->restore("task", 1, {"Ada", "better", 5}).value();
  EXPECT_EQ(restored.revision, (Revision{"task", 3, {"Ada", "better", 5}, {Origin::Kind::restore, "", 1}, 1, ""}));
  EXPECT_EQ(restored.document, first.document);
  EXPECT_EQ(restored.errors, first.errors);
  EXPECT_EQ(documents->entry("task")->document, first.document);
  EXPECT_EQ(documents->entry("task")->revision, restored.revision);
  EXPECT_EQ(documents->restore("task", 1, {})->revision, restored.revision) << "it is the same already";
  EXPECT_EQ(documents->restore("task", 3, {})->revision, restored.revision);
}

TEST_F(DocumentRevisions, BranchesARevisionWithItsIds) {
  const auto documents = open();
  const auto first = documents->put("task", kTask).value();
  documents->put("task", task_of("two")).value();
  const auto branch = documents->branch("task", {"mine", 1}, {"Ada", "", 5}).value();
  EXPECT_EQ(branch.revision, (Revision{"mine", 1, {"Ada", "", 5}, {Origin::Kind::branch, "task", 1}, 0, ""}));
  EXPECT_EQ(branch.document, first.document);
  EXPECT_EQ(documents->entry("mine")->document, first.document);
  EXPECT_EQ(documents->entry("task")->revision.number, 2);
  EXPECT_EQ(documents->branch("task", {"last", {}}, {})->revision.origin, (Origin{Origin::Kind::branch, "task", 2}));
  EXPECT_EQ(error_of(documents->branch("task", {"mine", {}}, {})).code, ErrorCode::conflict);
  EXPECT_EQ(error_of(documents->branch("task", {"no name", {}}, {})).code, ErrorCode::name);
  EXPECT_EQ(documents->list()->size(), 3U);
}

TEST_F(DocumentRevisions, KeepsARestoredOrBranchedDemoFromBeingReplaced) {
  const auto write = [this](const std::string& text) { std::ofstream(folder_ / "task.rcm.json") << text; };
  write(task_of("one"));
  const auto documents = open();
  ASSERT_TRUE(documents->put_demo(folder_, 1));
  write(task_of("two"));
  ASSERT_TRUE(documents->put_demo(folder_, 2));
  documents->restore("task", 1, {}).value();
  write(task_of("three"));
  ASSERT_TRUE(documents->put_demo(folder_, 3));
  EXPECT_EQ(documents->get("task")->document.root.doc, "one");
}

TEST_F(DocumentRevisions, RefusesAChangeOfAnotherRevisionThanTheLastOne) {
  const auto documents = open();
  const auto put = [&](const std::string& text, std::int64_t seen) {
    return documents->put("task", text, {}, {.draft = false, .seen = seen});
  };
  EXPECT_EQ(error_of(put(kTask, 1)).code, ErrorCode::conflict);
  documents->put("task", kTask).value();
  EXPECT_EQ(put(task_of("two"), 1)->revision.number, 2);
  EXPECT_EQ(error_of(put(task_of("three"), 1)).code, ErrorCode::conflict);
  EXPECT_EQ(documents->get("task")->document.root.doc, "two");
}

TEST_F(DocumentRevisions, HasBoundsOfAuthorAndMessage) {
  const auto documents = open();
  documents->put("task", kTask).value();
  const auto text = [](std::size_t length) {
    std::string out;
    for (std::size_t i = 0; i < length; ++i) out += "ü";
    return out;
  };
  for (const auto& [change, path] :
       {std::pair(Change{text(101), "", 1}, "author"), std::pair(Change{"", text(1001), 1}, "message")}) {
    for (const Error& error :
         {error_of(documents->put("task", task_of("two"), change)), error_of(documents->restore("task", 1, change)),
          error_of(documents->branch("task", {"mine", {}}, change))}) {
      EXPECT_EQ(error.code, ErrorCode::too_large);
      EXPECT_EQ(error.path, path);
    }
  }
  const Change longest{text(100), text(1000), 1};
  EXPECT_EQ(documents->put("task", task_of("two"), longest)->revision.change, longest);
}

TEST_F(DocumentRevisions, HasBoundsOfDocumentsAndRevisions) {
  const auto documents = open({.documents = 2, .revisions = 3});
  for (const char* name : {"a", "b"}) documents->put(name, kTask).value();
  EXPECT_EQ(error_of(documents->put("c", kTask)).code, ErrorCode::too_large);
  EXPECT_EQ(error_of(documents->branch("a", {"c", {}}, {})).code, ErrorCode::too_large);
  for (const char* doc : {"2", "3"}) documents->put("a", task_of(doc)).value();
  EXPECT_EQ(error_of(documents->put("a", task_of("4"))).code, ErrorCode::too_large);
  EXPECT_EQ(error_of(documents->restore("a", 1, {})).code, ErrorCode::too_large);
  EXPECT_EQ(documents->list()->size(), 2U);
  EXPECT_EQ(documents->get("a")->document.root.doc, "3");
  documents->put("b", task_of("2")).value();
}

}  // namespace
}  // namespace race::server
