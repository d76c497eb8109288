// Documents that are edited: what is published, when a session ends, and a store that fails.
#include <gmock/gmock.h>

#include "server/editing/editing.h"
#include "tests/unit/server/edited_document.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"

namespace race::server {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;

/// A subscriber of `task`, and who follows all documents: "edited 2", "replaced 3", "ended", "all", "changed task 2".
struct Follower final : EditPublisher, DocumentWatcher {
  void edited(const std::string& document, Value accepted) override {
    const std::int64_t revision = accepted.find("revision")->as_integer();
    said.push_back("edited " + std::to_string(revision));
    if (document != "task" || !replica) return;
    const auto edit = edit::read_edit(Dict{{"operations", *accepted.find("operations")}}).value();
    EXPECT_TRUE(edit::apply(*replica, edit)) << "an edit is missing before revision " << revision;
  }
  void replaced(const std::string& document, Value snapshot) override {
    said.push_back("replaced " + std::to_string(snapshot.find("revision")->as_integer()));
    if (document == "task") follow(snapshot);
  }
  void shown(const std::string&, Value snapshot) override {
    said.push_back("shown " + std::to_string(snapshot.find("revision")->as_integer()));
    follow(snapshot);
  }
  void ended(const std::string&, std::vector<Error> errors) override {
    said.push_back("ended " + std::string(name(errors.at(0).code)));
  }
  void all_replaced() override { said.emplace_back("all"); }
  void document_changed(const std::string& name, std::int64_t revision, bool has_violations) override {
    said.push_back("changed " + name + " " + std::to_string(revision) + (has_violations ? " wrong" : ""));
  }

  void follow(const Value& snapshot) {
    auto tree = edit::Tree::read(rcm::read_draft(*snapshot.find("json")).document);
    replica.reset();
    if (tree) replica.emplace(std::move(*tree));
  }
  std::vector<std::string> take() { return std::exchange(said, {}); }

  std::optional<edit::Tree> replica;
  std::vector<std::string> said;
};

class DocumentSessions : public DocumentStore {
 protected:
  DocumentSessions() {
    documents_ = open();
    for (const char* name : {"task", "second", "third"}) documents_->put(name, kWithIds).value();
  }
  static EditRequest request(const std::string& text, const std::string& token = "",
                             const std::string& author = "Ada") {
    return {{}, {}, author, "", token, set_doc("a", text)};
  }
  static EditRequest undo(const std::string& author = "Ada") {
    return {{}, {}, author, "", "", EditRequest::TakeBack::undo};
  }
  std::int64_t revision(const tl::expected<DocumentSession::EditResult, EditRefusal>& edited) {
    EXPECT_TRUE(edited) << edited.error().errors.front().message;
    return edited ? edited->edit.find("revision")->as_integer() : 0;
  }
  ErrorCode refusal(const tl::expected<DocumentSession::EditResult, EditRefusal>& edited) {
    EXPECT_FALSE(edited);
    return edited ? ErrorCode::json : edited.error().errors.front().code;
  }
  std::string stored() { return to_json(documents_->entry("task")->document); }
  std::string followed() { return to_json(rcm::write_document(follower_.replica->document())); }

  std::unique_ptr<Documents> documents_;
  Follower follower_;
};

TEST_F(DocumentSessions, TellsOfEachChangeInOrderOnceItIsStored) {
  Editing editing(*documents_, follower_, follower_);
  EXPECT_EQ(revision(editing.edit("task", request("x"))), 2);
  EXPECT_THAT(follower_.take(), ElementsAre("edited 2", "changed task 2"));
  ASSERT_TRUE(editing.put("task", kWithIds, {"Bob", "", 1}, {}));
  EXPECT_THAT(follower_.take(), ElementsAre("edited 3", "changed task 3"));
  ASSERT_TRUE(editing.put("task", kWithIds, {"Bob", "", 2}, {})) << "the same text";
  EXPECT_THAT(follower_.take(), ElementsAre());
  ASSERT_TRUE(editing.put("task", kTornDraft, {"Bob", "", 3}, as_draft()));
  EXPECT_THAT(follower_.take(), ElementsAre("replaced 4", "changed task 4 wrong"));
  EXPECT_EQ(refusal(editing.edit("task", request("y"))), ErrorCode::conflict);
  ASSERT_TRUE(editing.restore("task", 2, {"Bob", "", 4}));
  EXPECT_THAT(follower_.take(), ElementsAre("replaced 5", "changed task 5"));
  ASSERT_TRUE(editing.branch("task", {"new", {}}, {"Bob", "", 5}));
  EXPECT_THAT(follower_.take(), ElementsAre("replaced 1", "changed new 1"));
  EXPECT_EQ(refusal(editing.edit("nobody", request("y"))), ErrorCode::not_found);
  ASSERT_TRUE(editing.publish_snapshot("nobody"));
  EXPECT_THAT(follower_.take(), ElementsAre("ended not_found"));
}

TEST_F(DocumentSessions, SaysWhyADocumentCannotBeShown) {
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("UPDATE revision SET text = '' WHERE document = 'task'");
  Editing editing(*documents_, follower_, follower_);
  ASSERT_TRUE(editing.publish_snapshot("task"));
  EXPECT_THAT(follower_.take(), ElementsAre("ended corrupt"));
}

TEST_F(DocumentSessions, KeepsSoManySessionsAndGoesOnWithTheOthersFromTheStore) {
  Editing editing(*documents_, follower_, follower_, {.sessions = 2, .turn = milliseconds(5000)});
  for (const char* name : {"task", "second", "third"}) editing.edit(name, request("x", "t"));
  EXPECT_EQ(editing.sessions(), 2U);
  for (const char* name : {"task", "second", "third", "nobody"}) editing.edit(name, request("x", "t"));
  EXPECT_EQ(editing.sessions(), 2U);
  EXPECT_EQ(documents_->entry("task")->revision.number, 2) << "its token is known again";
  EXPECT_EQ(revision(editing.edit("task", undo())), 3);
  EXPECT_EQ(stored(), to_json(documents_->entry("task", 1)->document));
}

TEST_F(DocumentSessions, WaitsABoundedTimeForADocument) {
  Editing editing(*documents_, follower_, follower_, {.sessions = 2, .turn = milliseconds(20)});
  {
    const auto pause = editing.pause();
    ASSERT_TRUE(pause);
    EXPECT_EQ(refusal(editing.edit("task", request("x"))), ErrorCode::unavailable);
    EXPECT_EQ(editing.put("task", kTask, {}, {}).error().front().code, ErrorCode::unavailable);
    EXPECT_EQ(editing.publish_snapshot("task").error().code, ErrorCode::unavailable);
    EXPECT_EQ(editing.pause().error().code, ErrorCode::unavailable) << "one at a time";
    EXPECT_EQ(refusal(editing.edit("task", request("x"))), ErrorCode::unavailable) << "the first one goes on";
  }
  EXPECT_THAT(follower_.take(), ElementsAre("all"));
  EXPECT_EQ(revision(editing.edit("task", request("x"))), 2);
}

TEST_F(DocumentSessions, KnowsTheLastTokensOfEachAuthor) {
  auto session = DocumentSession::read(*documents_, "task").value();
  const auto edit = [&](std::size_t number, const std::string& author = "Ada") {
    return revision(session.edit(request(std::to_string(number), "t-" + std::to_string(number), author), 1));
  };
  for (std::size_t i = 0; i < DocumentSession::kTokens; ++i) ASSERT_EQ(edit(i), static_cast<std::int64_t>(i + 2));
  EXPECT_EQ(edit(0), 2) << "the oldest one";
  const std::int64_t next = session.revision() + 1;
  EXPECT_EQ(edit(0, "Bob"), next) << "of somebody else";
  EXPECT_EQ(edit(1), 3);
  EXPECT_EQ(edit(0), next + 1) << "it is forgotten";
}

TEST_F(DocumentSessions, BeginsAnewAfterAPastThatComesOutOtherwise) {
  ASSERT_TRUE(append(*documents_, set_doc("a", "x")));
  RevisionText wrong = next_of(*documents_, set_doc("a", "y"), "Zoe");
  wrong.revision.origin = {Origin::Kind::undo, "", 2};  // Zoe has nothing to undo
  ASSERT_TRUE(documents_->append_edit(wrong, {set_doc("a", "y")}));
  Editing editing(*documents_, follower_, follower_);
  EXPECT_EQ(refusal(editing.edit("task", undo())), ErrorCode::not_found);
  EXPECT_EQ(revision(editing.edit("task", request("z"))), 4);
  EXPECT_EQ(revision(editing.edit("task", undo())), 5);
  EXPECT_EQ(stored(), to_json(documents_->entry("task", 3)->document));
}

TEST_F(DocumentSessions, ThatTheStoreFailsIsAsIfNobodyHadAskedOrTheDocumentIsReadAnew) {
  using sqlite::FaultyVfs;
  documents_.reset();
  for (const auto fault : {FaultyVfs::Fault::full, FaultyVfs::Fault::io}) {
    bool has_failed = true;
    for (std::uint64_t nth = 1; has_failed; ++nth) {
      SCOPED_TRACE("operation " + std::to_string(nth));
      FaultyVfs vfs;
      documents_ = Documents::open(path()).value();
      follower_.replica.reset();
      {
        Editing editing(*documents_, follower_, follower_);
        ASSERT_TRUE(editing.publish_snapshot("task"));
        vfs.fail_at(nth, fault, true);
        const std::string token = "t-" + std::to_string(nth) + (fault == FaultyVfs::Fault::io ? "-io" : "");
        const auto edited = editing.edit("task", request(token, token));
        has_failed = vfs.has_failed();
        EXPECT_TRUE(edited || (has_failed && refusal(edited) == ErrorCode::storage));
        vfs.repair();
        const std::int64_t made = revision(editing.edit("task", request(token, token)));
        EXPECT_EQ(made, documents_->entry("task")->revision.number) << "once";
        EXPECT_EQ(followed(), stored());
        EXPECT_EQ(revision(editing.edit("task", undo())), made + 1);
        EXPECT_EQ(followed(), stored());
        EXPECT_EQ(stored(), to_json(documents_->entry("task", made - 1)->document));
      }
      documents_.reset();
    }
  }
}

}  // namespace
}  // namespace race::server
