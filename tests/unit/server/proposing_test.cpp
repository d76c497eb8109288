// What the channel `proposals` tells: each proposal that is new, decided, outdated, or outdated no more, in order.
#include "server/editing/proposing.h"

#include <gmock/gmock.h>

#include "tests/unit/server/boxed_subscriber.h"
#include "tests/unit/server/document_store.h"

namespace race::server {
namespace {

struct NoPublisher final : EditPublisher {
  void edited(const std::string&, Value) override {}
  void replaced(const std::string&, Value) override {}
  void shown(const std::string&, Value) override {}
  void ended(const std::string&, std::vector<Error>) override {}
  void all_replaced() override {}
};

struct ProposalReader final : BoxedSubscriber {
  /// Waits for the next message: "snapshot 1000 open", "delta 1000 accepted 1001 outdated".
  std::string heard() {
    const Value message = next();
    std::string out = message.find("kind")->as_string();
    for (const Value& each : message.find("data")->find("proposals")->as_list())
      out += " " + each.find("id")->as_string() + " " + each.find("status")->as_string();
    return out;
  }
};

class ProposingTest : public DocumentStore {
 protected:
  ProposingTest() {
    EXPECT_TRUE(documents_->put("task", kTask));
    watchers_.add(proposing_);
    EXPECT_TRUE(proposing_.reload());
    hub_.subscribe(reader_, "proposals", {});
    EXPECT_EQ(reader_->heard(), "snapshot");
  }
  ~ProposingTest() override { hub_.shut_down(); }
  Checked<Proposal> propose(std::int64_t time, std::int64_t base = 1, const std::string& document = "task",
                            const char* text = kTask) {
    Proposal proposal{.document = document, .base = base, .author = "agent", .note = "why", .created_ms = time};
    return proposing_.propose(std::move(proposal), text);
  }
  /// Everything that was told until now.
  std::vector<std::string> told() {
    std::vector<std::string> all;
    Proposal last{.document = "last", .created_ms = ++last_};
    const std::string end = "delta " + std::to_string(proposing_.propose(std::move(last), kTask)->id) + " open";
    for (std::string each = reader_->heard(); each != end; each = reader_->heard()) all.push_back(each);
    return all;
  }

  Pool pool_{1};
  Hub hub_{pool_, 1000, [this](const std::string&) {
             return Source{false, [this] { proposing_.publish_snapshot(); }, {}};
           }};
  std::unique_ptr<Documents> documents_ = open();
  std::unique_ptr<Proposals> proposals_ = Proposals::open(path()).value();
  NoPublisher publisher_;
  DocumentWatchers watchers_;
  Editing editing_{*documents_, publisher_, watchers_};
  Proposing proposing_{*proposals_, *documents_, editing_, hub_};
  std::shared_ptr<ProposalReader> reader_ = std::make_shared<ProposalReader>();
  std::int64_t last_ = 1'000'000;
};

using testing::ElementsAre;

constexpr const char* kBetter = R"({"rcm": 1, "root": {"state": "R", "doc": "better", "children": [{"state": "A"}]}})";

TEST_F(ProposingTest, TellsOfEachThatIsNewOrDecided) {
  ASSERT_TRUE(propose(1, 1, "task", kBetter));
  ASSERT_TRUE(propose(2, 0, "fresh"));
  ASSERT_TRUE(proposing_.decide(2, {.status = Proposal::Status::withdrawn}));
  const auto accepted = proposing_.accept(1, "Ada~1", 7);
  ASSERT_TRUE(accepted);
  EXPECT_EQ(accepted->revision, 2);
  EXPECT_EQ(documents_->entry("task")->revision.change, (Change{"Ada~1", "why", 7}));
  EXPECT_THAT(told(), ElementsAre("delta 1 open", "delta 2 open", "delta 2 withdrawn", "delta 1 accepted")) << "once";
}

TEST_F(ProposingTest, IsTakenBackByWhoHasAcceptedItAlsoAfterARestart) {
  const auto undo = [](Editing& editing, const std::string& author) {
    return editing.edit("task", {{}, {}, author, "", "", EditRequest::TakeBack::undo});
  };
  const Value before = documents_->entry("task")->document;
  ASSERT_TRUE(propose(1, 1, "task", kBetter));
  ASSERT_TRUE(proposing_.accept(1, "Ada~1", 7));
  EXPECT_FALSE(undo(editing_, "agent")) << "who has only proposed it";
  Editing again{*documents_, publisher_, watchers_};
  const auto undone = undo(again, "Ada~1");
  ASSERT_TRUE(undone);
  EXPECT_EQ(*undone->edit.find("of"), Value(2));
  EXPECT_EQ(documents_->entry("task")->document, before);
}

TEST_F(ProposingTest, TellsOfThoseThatTheDocumentHasLeftBehindOnce) {
  ASSERT_TRUE(propose(1));
  ASSERT_TRUE(propose(2, 0, "fresh"));
  ASSERT_TRUE(editing_.put("task", kBetter, {"Bob"}, {}));
  ASSERT_TRUE(editing_.put("task", kTask, {"Bob", "", 1}, {}));
  ASSERT_TRUE(editing_.put("fresh", kTask, {"Bob"}, {}));
  ASSERT_TRUE(editing_.put("other", kTask, {"Bob"}, {}));
  ASSERT_TRUE(editing_.remove("fresh"));
  EXPECT_THAT(told(),
              ElementsAre("delta 1 open", "delta 2 open", "delta 1 outdated", "delta 2 outdated", "delta 2 open"));
}

TEST_F(ProposingTest, RefusesWhatIsOutdatedAndItStaysOpen) {
  ASSERT_TRUE(propose(1));
  ASSERT_TRUE(editing_.put("task", kBetter, {"Bob"}, {}));
  const Error refused = error_of(proposing_.accept(1, "Ada", 7));
  EXPECT_EQ(refused.code, ErrorCode::conflict);
  EXPECT_THAT(refused.message, testing::HasSubstr("the last revision is 2"));
  EXPECT_EQ(proposals_->find(1)->status, Proposal::Status::open);
  EXPECT_EQ(error_of(propose(2, 1)).code, ErrorCode::conflict) << "what would be outdated at once";
}

TEST_F(ProposingTest, RefusesWhatCouldNotBeStored) {
  EXPECT_FALSE(propose(1, 1, "task", kDraft));
  EXPECT_FALSE(propose(1, 1, "task", kTornDraft));
  EXPECT_EQ(error_of(propose(1, 0, "no name")).code, ErrorCode::name);
  EXPECT_EQ(error_of(propose(1, 0)).code, ErrorCode::conflict);
  EXPECT_EQ(error_of(propose(1, 3, "nothing")).code, ErrorCode::conflict);
  EXPECT_THAT(told(), testing::IsEmpty());
}

TEST_F(ProposingTest, TellsWhoComesLaterOrAfterABackupWhatIsThere) {
  ASSERT_TRUE(propose(1));
  ASSERT_TRUE(propose(2));
  ASSERT_TRUE(proposing_.decide(1, {}));
  const auto late = std::make_shared<ProposalReader>();
  hub_.subscribe(late, "proposals", {});
  EXPECT_EQ(late->heard(), "snapshot 2 open");
  ASSERT_TRUE(editing_.put("task", kBetter, {"Bob"}, {}));
  EXPECT_EQ(late->heard(), "delta 2 outdated");
  ASSERT_TRUE(proposals_->decide(2, {}));  // as a store that is another one
  ASSERT_TRUE(proposing_.reload());
  EXPECT_EQ(late->heard(), "snapshot");
}

TEST_F(ProposingTest, KeepsAsMuchOfALongNoteAsAMessageHolds) {
  Proposal proposal{.document = "task", .base = 1, .note = std::string(2000, 'n'), .created_ms = 1};
  ASSERT_TRUE(proposing_.propose(std::move(proposal), kBetter));
  ASSERT_TRUE(proposing_.accept(1, "Ada", 7));
  EXPECT_EQ(documents_->entry("task")->revision.change.message, std::string(1000, 'n'));
}

}  // namespace
}  // namespace race::server
