// Documents that several authors edit: what is accepted is stored and told, in order; what is bounded.
#include "server/editing/editing.h"

#include <gmock/gmock.h>

#include <future>
#include <iostream>
#include <new>
#include <thread>

#include "core/value/json.h"
#include "server/editing/edit_queue.h"
#include "tests/unit/core/edit/random_edits.h"
#include "tests/unit/server/boxed_subscriber.h"
#include "tests/unit/server/document_store.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"
#include "tests/unit/setting.h"

namespace race::server {
namespace {

using testing::ElementsAre;

struct Recorder final : EditPublisher, DocumentWatcher {
  void edited(const std::string& document, Value accepted) override {
    add(document, " edit ", *accepted.find("revision"));
  }
  void replaced(const std::string& document, Value snapshot) override {
    add(document, " text ", *snapshot.find("revision"));
  }
  void shown(const std::string& document, Value snapshot) override {
    add(document, " shown ", *snapshot.find("revision"));
  }
  void ended(const std::string& document, std::vector<Error> errors) override {
    told.push_back(document + " ended " + std::string(name(errors.at(0).code)));
  }
  void all_replaced() override {
    told.push_back("all");
    if (const auto once = std::exchange(during, {})) once();
  }
  void document_changed(const std::string& name, std::int64_t revision, bool has_violations) override {
    changes.push_back(name + " " + std::to_string(revision) + (has_violations ? " with violations" : ""));
  }
  void add(const std::string& document, const char* what, const Value& revision) {
    told.push_back(document + what + std::to_string(revision.as_integer()));
    if (const auto once = std::exchange(during, {})) once();
  }
  std::vector<std::string> told, changes;
  std::function<void()> during;  // once
};

EditRequest request(const std::string& author, std::string json) {
  std::replace(json.begin(), json.end(), '\'', '"');
  const Value value = parse_json(json).value();
  std::vector<Error> errors;
  Fields fields(value, "", "the request", errors, Fields::Paths::field);
  EditRequest out = read_edit_request(fields, errors);
  fields.close();
  EXPECT_TRUE(errors.empty()) << to_string(errors.front());
  out.author = author;
  return out;
}

EditRequest doc(const std::string& author, int revision, const std::string& text, const std::string& token = "") {
  return request(author, "{'revision': " + std::to_string(revision) +
                             (token.empty() ? "" : ", 'request': '" + token + "'") +
                             ", 'operations': [{'op': 'set', 'id': 'a', 'field': 'doc', 'value': '" + text + "'}]}");
}

EditRequest take_back(const std::string& author, const char* what, const std::string& token = "") {
  return request(author, std::string("{'revision': 1, '") + what + "': true" +
                             (token.empty() ? "" : ", 'request': '" + token + "'") + "}");
}

constexpr const char* kEdited = R"({"rcm": 1, "root": {"state": "R", "children": [
    {"state": "A", "meta": {"id": "a"}}, {"state": "B", "meta": {"id": "b"}}], "meta": {"id": "r"}}})";

class EditingTest : public DocumentStore {
 protected:
  EditingTest() {
    begin();
    documents_->put("t", kEdited, {"Eve", "", 1}).value();
  }
  void begin(Editing::Limits limits = {}) {
    editing_.reset();
    documents_ = open();
    editing_ = std::make_unique<Editing>(*documents_, recorder_, recorder_, limits);
  }
  std::int64_t accepted(const EditRequest& request, const std::string& name = "t") {
    const auto edited = editing_->edit(name, request);
    EXPECT_TRUE(edited) << (edited ? "" : to_string(edited.error().errors.front()));
    return edited ? edited->edit.find("revision")->as_integer() : 0;
  }
  EditRefusal refused(const EditRequest& request, const std::string& name = "t") {
    const auto edited = editing_->edit(name, request);
    EXPECT_FALSE(edited);
    return edited ? EditRefusal{} : edited.error();
  }
  std::string text() { return to_json(documents_->entry("t")->document); }

  Recorder recorder_;
  std::unique_ptr<Documents> documents_;
  std::unique_ptr<Editing> editing_;
};

TEST_F(EditingTest, StoresAndTellsEachEditInOrder) {
  EXPECT_EQ(accepted(doc("Ada", 1, "x")), 2);
  EXPECT_EQ(accepted(request("Bob",
                             "{'revision': 1, 'operations': [{'op': 'set', 'id': 'r', 'field': 'first',"
                             " 'value': 'Nobody'}]}")),
            3);
  EXPECT_THAT(recorder_.told, ElementsAre("t edit 2", "t edit 3"));
  EXPECT_THAT(recorder_.changes, ElementsAre("t 2", "t 3 with violations"));
  EXPECT_EQ(documents_->entry("t")->revision.change.author, "Bob");
  EXPECT_EQ(documents_->entry("t")->revision.errors, 1);
}

TEST_F(EditingTest, RefusesAConflictAndNamesItsReason) {
  accepted(doc("Ada", 1, "x"));
  const EditRefusal refusal = refused(request("Bob", "{'revision': 1, 'operations': [{'op': 'remove', 'id': 'a'}]}"));
  EXPECT_EQ(refusal.errors.front().code, ErrorCode::conflict);
  EXPECT_EQ(refusal.revision, 2);
  EXPECT_EQ(refusal.author, "Ada");
  EXPECT_EQ(documents_->entry("t")->revision.number, 2);
}

TEST_F(EditingTest, HasAStrictPrecondition) {
  EditRequest edit = doc("Ada", 1, "x");
  edit.if_match = 1;
  EXPECT_EQ(accepted(edit), 2);
  EXPECT_EQ(refused(edit).of, EditRefusal::Of::precondition);
}

TEST_F(EditingTest, MakesAnEditOnceForItsTokenAlsoAfterARestart) {
  EXPECT_EQ(accepted(doc("Ada", 1, "x", "one")), 2);
  EXPECT_EQ(accepted(take_back("Ada", "undo", "two")), 3);
  for (int i = 0; i < 2; ++i) {
    const auto again = editing_->edit("t", take_back("Ada", "undo", "two")).value();
    EXPECT_TRUE(again.was_there);
    EXPECT_EQ(again.edit.find("kind")->as_string(), "undo");
    EXPECT_EQ(again.edit.find("of")->as_integer(), 2);
    EXPECT_EQ(accepted(doc("Ada", 1, "x", "one")), 2);
    begin();
  }
  EXPECT_EQ(accepted(doc("Bob", 3, "y", "one")), 4) << "a token is its author's";
}

TEST_F(EditingTest, KnowsTokensFromBeforeAnotherText) {
  EXPECT_EQ(accepted(doc("Ada", 1, "x", "one")), 2);
  editing_->put("t", kEdited, {"Eve", "", 2}, {}).value();
  EXPECT_EQ(accepted(doc("Bob", 3, "y", "two")), 4);
  editing_->restore("t", 1, {"Eve", "", 3}).value();
  begin();
  EXPECT_EQ(accepted(doc("Ada", 1, "x", "one")), 2);
  EXPECT_EQ(accepted(doc("Bob", 3, "y", "two")), 4);
  EXPECT_EQ(documents_->entry("t")->revision.number, 5);
}

TEST_F(EditingTest, ForgetsTheOldestTokens) {
  accepted(doc("Ada", 1, "first", "first"));
  for (std::size_t i = 0; i < DocumentSession::kTokens; ++i)
    accepted(doc("Ada", static_cast<int>(i) + 2, "x", "t" + std::to_string(i)));
  EXPECT_TRUE(editing_->edit("t", doc("Ada", 3, "x", "t0"))->was_there);
  EXPECT_FALSE(editing_->edit("t", doc("Ada", 900, "x", "first"))->was_there);
  begin();
  EXPECT_TRUE(editing_->edit("t", doc("Ada", 4, "x", "t1"))->was_there);
  EXPECT_FALSE(editing_->edit("t", doc("Ada", 900, "x", "t0"))->was_there);
}

TEST_F(EditingTest, TakesBackWhatWasEditedBeforeARestart) {
  const std::string first = text();
  accepted(doc("Ada", 1, "x"));
  accepted(doc("Bob", 2, "y"));
  accepted(take_back("Bob", "undo"));
  begin();
  const auto redone = editing_->edit("t", take_back("Bob", "redo")).value().edit;
  EXPECT_EQ(redone.find("of")->as_integer(), 4);
  accepted(take_back("Bob", "undo"));
  begin();
  accepted(take_back("Ada", "undo"));
  EXPECT_EQ(text(), first);
  EXPECT_EQ(refused(take_back("Ada", "undo")).errors.front().code, ErrorCode::not_found);
}

TEST_F(EditingTest, TakesBackNothingFromBeforeAnotherText) {
  accepted(doc("Ada", 1, "x"));
  editing_->put("t", kTask, {"Eve", "", 2}, {}).value();
  begin();
  EXPECT_EQ(refused(take_back("Ada", "undo")).errors.front().code, ErrorCode::not_found);
}

TEST_F(EditingTest, TellsATextThatIsPutAsTheEditThatItIs) {
  accepted(doc("Ada", 1, "x"));
  editing_->put("t", kEdited, {"Eve", "as it was", 2}, {}).value();
  EXPECT_THAT(recorder_.told, ElementsAre("t edit 2", "t edit 3"));
  EXPECT_EQ(accepted(take_back("Eve", "undo")), 4);
  EXPECT_NE(text().find("\"doc\":\"x\""), std::string::npos);
  editing_->restore("t", 1, {"Eve", "", 3}).value();
  editing_->restore("t", 1, {"Eve", "", 4}).value();
  EXPECT_THAT(recorder_.told, ElementsAre("t edit 2", "t edit 3", "t edit 4", "t edit 5"));
}

TEST_F(EditingTest, TellsThatADocumentWasRemovedAndThatThereIsAnotherOne) {
  accepted(doc("Ada", 1, "x", "one"));
  EXPECT_EQ(editing_->remove("t", 1).error().code, ErrorCode::conflict);
  ASSERT_TRUE(editing_->remove("t"));
  EXPECT_EQ(refused(doc("Ada", 2, "y")).errors.front().code, ErrorCode::not_found);
  EXPECT_EQ(editing_->remove("t").error().code, ErrorCode::not_found);
  editing_->put("t", kEdited, {"Eve", "", 3}, {}).value();
  EXPECT_THAT(recorder_.told, ElementsAre("t edit 2", "t ended not_found", "t text 3"));
  EXPECT_EQ(accepted(doc("Ada", 3, "y", "one")), 4) << "the token was that of an edit of the other document";
  EXPECT_EQ(refused(take_back("Eve", "undo")).errors.front().code, ErrorCode::not_found);
}

TEST_F(EditingTest, BeginsAnewWithATextThatNoEditLeadsTo) {
  accepted(doc("Ada", 1, "x"));
  editing_->put("t", R"({"rcm": 1, "root": {"state": "R", "meta": {"id": "other"}}})", {"Eve", "", 2}, {}).value();
  editing_->put("t", kTornDraft, {"Eve", "", 3}, as_draft()).value();
  EXPECT_THAT(recorder_.told, ElementsAre("t edit 2", "t text 3", "t text 4"));
  const EditRefusal refusal = refused(doc("Ada", 4, "y"));
  EXPECT_EQ(refusal.errors.front().code, ErrorCode::conflict);
  EXPECT_GT(refusal.errors.size(), 1U) << "and what is wrong with its shape";
  editing_->put("t", kEdited, {"Eve", "", 4}, {}).value();
  EXPECT_EQ(accepted(doc("Ada", 5, "y")), 6);
}

TEST_F(EditingTest, EditsADraftWithViolations) {
  editing_->put("d", kDraft, {"Eve", "", 1}, as_draft()).value();
  const std::string root = document_of(documents_->put("e", kTask)).root.meta.id;
  const auto edited = editing_->edit(
      "d", request("Ada", "{'revision': 1, 'operations': [{'op': 'set', 'id': '" + root + "', 'field': 'first'}]}"));
  ASSERT_TRUE(edited) << to_string(edited.error().errors.front());
  EXPECT_TRUE(edited->edit.find("errors")->as_list().empty());
}

TEST_F(EditingTest, OfNoDocumentIsNotFound) {
  EXPECT_EQ(refused(doc("Ada", 1, "x"), "nobody").errors.front().code, ErrorCode::not_found);
  ASSERT_TRUE(editing_->publish_snapshot("nobody"));
  ASSERT_TRUE(editing_->publish_snapshot("t"));
  EXPECT_THAT(recorder_.told, ElementsAre("nobody ended not_found", "t shown 1"));
}

TEST_F(EditingTest, KeepsABoundedNumberOfDocuments) {
  begin({.sessions = 2});
  for (const char* name : {"u", "v", "w"}) {
    editing_->put(name, kEdited, {"Eve", "", 1}, {}).value();
    accepted(doc("Ada", 1, "x"), name);
    EXPECT_LE(editing_->sessions(), 2U);
  }
  EXPECT_EQ(accepted(take_back("Ada", "undo"), "u"), 3) << "what was forgotten is read again";
}

TEST_F(EditingTest, WaitsABoundedTimeForOthers) {
  begin({.turn = std::chrono::milliseconds(50)});
  std::promise<void> begun, done;
  recorder_.during = [&] {
    begun.set_value();
    done.get_future().wait();
  };
  std::thread other([&] { accepted(doc("Ada", 1, "x")); });
  begun.get_future().wait();
  EXPECT_EQ(refused(doc("Bob", 1, "y")).errors.front().code, ErrorCode::unavailable);
  EXPECT_EQ(editing_->pause().error().code, ErrorCode::unavailable);
  editing_->put("u", kEdited, {"Eve", "", 1}, {}).value();
  EXPECT_EQ(accepted(doc("Bob", 1, "y"), "u"), 2) << "another document is free";
  done.set_value();
  other.join();
}

TEST_F(EditingTest, ChangesNothingDuringAPauseAndReadsAllAgainAfterIt) {
  begin({.turn = std::chrono::milliseconds(50)});
  accepted(doc("Ada", 1, "x"));
  {
    const auto pause = editing_->pause().value();
    EXPECT_EQ(refused(doc("Bob", 1, "y")).errors.front().code, ErrorCode::unavailable);
    recorder_.during = [this] { EXPECT_FALSE(editing_->edit("t", doc("Bob", 2, "z"))) << "before all are told"; };
  }
  EXPECT_EQ(recorder_.told.back(), "all");
  EXPECT_EQ(accepted(doc("Bob", 2, "y")), 3);
}

TEST_F(EditingTest, DocumentsChangeAgainAfterAPauseAlsoIfNobodyCanBeTold) {
  accepted(doc("Ada", 1, "x"));
  {
    const auto pause = editing_->pause().value();
    recorder_.during = [] { throw std::bad_alloc(); };
  }
  EXPECT_EQ(accepted(doc("Bob", 2, "y")), 3);
}

TEST_F(EditingTest, IsNeverAheadOfTheDisk) {
  editing_.reset();
  documents_.reset();
  sqlite::FaultyVfs vfs;
  begin();
  accepted(doc("Ada", 1, "x", "one"));
  for (const auto fault : {sqlite::FaultyVfs::Fault::full, sqlite::FaultyVfs::Fault::io}) {
    vfs.fail_at(1, fault, true);
    EXPECT_EQ(refused(doc("Ada", 2, "lost", "two")).errors.front().code, ErrorCode::storage);
    vfs.repair();
    EXPECT_EQ(documents_->entry("t")->revision.number, 2);
  }
  EXPECT_EQ(recorder_.told, std::vector<std::string>{"t edit 2"});
  EXPECT_EQ(accepted(doc("Ada", 2, "y", "two")), 3);
  EXPECT_EQ(accepted(take_back("Ada", "undo")), 4);
  EXPECT_NE(text().find("\"doc\":\"x\""), std::string::npos);
  editing_.reset();
  documents_.reset();
}

TEST_F(EditingTest, QueuesTheEditsOfTheStreamInOrderAndWithABound) {
  Pool pool{1};
  Hub hub(pool, 1, [](const std::string&) { return std::nullopt; });
  const auto client = std::make_shared<BoxedSubscriber>();
  NoRecords records;
  EditQueue queue(*editing_, hub, records, 3);
  std::promise<void> begun, done;
  recorder_.during = [&] {
    begun.set_value();
    done.get_future().wait();
  };
  const auto ask = [&](const std::string& token) {
    queue.request_edit(
        client, Dict{{"type", "edit"},
                     {"document", "t"},
                     {"request", token},
                     {"revision", 1},
                     {"operations", List{Dict{{"op", "set"}, {"id", "a"}, {"field", "doc"}, {"value", token}}}}});
  };
  ask("e0");
  begun.get_future().wait();
  for (const char* token : {"e1", "e2", "e3", "e4"}) ask(token);
  Value refused = client->next();
  EXPECT_EQ(refused.find("kind")->as_string(), "edit_refused");
  EXPECT_EQ(refused.find("data")->find("request")->as_string(), "e4");
  EXPECT_EQ(to_json(*refused.find("data")->find("errors")).find("unavailable") != std::string::npos, true);
  done.set_value();
  for (const char* token : {"e0", "e1", "e2", "e3"}) {
    const Value message = client->next();
    EXPECT_EQ(message.find("kind")->as_string(), "edit_accepted");
    EXPECT_EQ(message.find("data")->find("request")->as_string(), token);
  }
  for (int i = 0; i < 3; ++i) queue.request_snapshot("t");
  queue.stop();
  ask("e5");
  EXPECT_EQ(client->next().find("kind")->as_string(), "edit_refused");
}

TEST_F(EditingTest, OfRandomAuthorsCanBeReadAgainAtEveryRevision) {
  const std::uint64_t seed = setting("RACE_SEED", 20261122);
  std::cout << "RACE_SEED=" << seed << std::endl;
  edit::RandomEdits random(seed, "r");
  std::vector<std::string> texts{"", text()};
  std::size_t refused = 0;
  for (int i = 0; i < 400; ++i) {
    const std::string author = "author" + std::to_string(random.pick(4));
    const auto tree = edit::Tree::read(rcm::read_draft(documents_->entry("t")->document).document).value();
    EditRequest edit{
        .revision = texts.size() - 1, .if_match = {}, .author = author, .message = "", .token = "", .what = {}};
    if (random.chance(0.3))
      edit.what = random.chance(0.6) ? EditRequest::TakeBack::undo : EditRequest::TakeBack::redo;
    else
      edit.what = random.edit(tree);
    if (!editing_->edit("t", edit)) {
      ++refused;
      continue;
    }
    texts.push_back(text());
    if (random.chance(0.05)) begin();
  }
  EXPECT_LT(refused, 300U);
  for (std::size_t i = 1; i < texts.size(); ++i)
    EXPECT_EQ(to_json(documents_->entry("t", static_cast<std::int64_t>(i))->document), texts[i]) << "revision " << i;
}

}  // namespace
}  // namespace race::server
