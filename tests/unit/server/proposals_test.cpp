// What is proposed is kept until somebody has decided; an accepted proposal is a revision, once.
#include "server/store/proposals.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "core/value/json.h"
#include "server/store/proposal_rows.h"
#include "tests/unit/server/document_store.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"

namespace race::server {
namespace {

using Status = Proposal::Status;

constexpr const char* kProposed =
    R"({"rcm": 1, "root": {"state": "R", "doc": "better", "children": [{"state": "A"}, {"state": "B"}]}})";

struct ProposalsTest : DocumentStore {
  ProposalsTest() {
    documents = open();
    EXPECT_TRUE(documents->put("task", kTask));
    proposals = Proposals::open(path()).value();
  }
  std::string prepared(const std::string& document, std::int64_t base, const char* text = kProposed) const {
    Documents::Put options;
    options.is_new = base == 0;
    if (base > 0) options.seen = base;
    return documents->prepare(document, text, options).value();
  }
  Expected<Proposal> try_propose(const std::string& author, std::int64_t base = 1,
                                 const std::string& document = "task") {
    Proposal proposal{.document = document, .base = base, .author = author, .note = "why", .created_ms = time};
    return proposals->add(std::move(proposal), prepared(document, base));
  }
  Proposal propose(const std::string& author, std::int64_t base = 1, const std::string& document = "task") {
    return try_propose(author, base, document).value();
  }
  Expected<Proposal> decide(std::int64_t id, Status status) {
    return proposals->decide(id, {.status = status, .by = "Ada", .time_ms = ++time});
  }
  std::vector<std::int64_t> ids(const ProposalQuery& query) {
    std::vector<std::int64_t> out;
    const ProposalPage page = proposals->list(query).value();
    for (const Proposal& each : page.proposals) out.push_back(each.id);
    return out;
  }
  std::unique_ptr<Documents> documents;
  std::unique_ptr<Proposals> proposals;
  std::int64_t time = 1000;
};

TEST_F(ProposalsTest, AreThereWhenTheStoreIsOpenedAgain) {
  const Proposal made = propose("agent");
  EXPECT_EQ(std::string(shown_status(made)), "open");
  proposals = Proposals::open(path()).value();
  const ProposalText found = proposals->read(made.id).value();
  EXPECT_EQ(found.proposal, made);
  EXPECT_EQ(found.text, prepared("task", 1)) << "with the ids of the revision that it changes";
  EXPECT_EQ(proposals->find(made.id + 1).error().code, ErrorCode::not_found);
}

TEST_F(ProposalsTest, AreRevisionsOnceTheyAreAccepted) {
  const Proposal made = propose("agent");
  const auto stored = documents->accept(made.id, {"Ada~1", "why", 77}).value();
  const Revision wanted{"task", 2, {"Ada~1", "why", 77}, {Origin::Kind::proposal, "", made.id, "agent"}, 0, "better"};
  EXPECT_EQ(stored.revision, wanted);
  documents = open();
  EXPECT_EQ(documents->entry("task")->revision, wanted);
  const Proposal accepted = proposals->find(made.id).value();
  EXPECT_EQ(accepted.status, Status::accepted);
  EXPECT_EQ(accepted.revision, 2);
  EXPECT_EQ(accepted.decided_by, "Ada~1");
  EXPECT_EQ(accepted.decided_ms, 77);
  EXPECT_EQ(error_of(documents->accept(made.id, {})).code, ErrorCode::conflict) << "once";
  EXPECT_EQ(decide(made.id, Status::declined).error().code, ErrorCode::conflict);
}

TEST_F(ProposalsTest, AreStoredAsTheEditThatTheyAre) {
  const Proposal made = propose("agent");
  ASSERT_TRUE(documents->accept(made.id, {"Ada~1"}));
  const DocumentPast past = documents->past("task", 10).value();
  ASSERT_EQ(past.edits.size(), 1U);
  EXPECT_EQ(past.edits[0].revision.origin.kind, Origin::Kind::proposal);
  EXPECT_EQ(past.edits[0].edit.edit.operations.size(), 1U) << "the `doc` of the root";
  EXPECT_EQ(documents->entry("task")->document, parse_json(proposals->read(made.id)->text).value());
}

TEST_F(ProposalsTest, OfAnotherRootAreStoredWhole) {
  const char* other = R"({"rcm": 1, "root": {"state": "Other", "meta": {"id": "other"}}})";
  const Proposal made =
      proposals->add({.document = "task", .base = 1, .created_ms = time}, prepared("task", 1, other)).value();
  ASSERT_TRUE(documents->accept(made.id, {"Ada"}));
  EXPECT_TRUE(documents->past("task", 10)->edits.empty());
  EXPECT_EQ(document_of(documents->entry("task")).root.name, "Other");
}

TEST_F(ProposalsTest, OfANewDocumentMakeIt) {
  const Proposal made = propose("agent", 0, "fresh");
  const auto stored = documents->accept(made.id, {"Ada"}).value();
  EXPECT_TRUE(stored.is_new);
  EXPECT_EQ(stored.revision.document, "fresh");
  EXPECT_EQ(error_of(documents->prepare("fresh", kTask, {.draft = false, .seen = {}, .is_new = true})).code,
            ErrorCode::conflict);
}

TEST_F(ProposalsTest, AreOutdatedWhenTheDocumentHasAnotherRevision) {
  const Proposal made = propose("agent"), of_new = propose("agent", 0, "fresh");
  ASSERT_TRUE(edit_doc(*documents, "task", "other", {"Bob"}));
  ASSERT_TRUE(documents->put("fresh", kTask));
  EXPECT_THAT(ids({.status = "outdated"}), testing::ElementsAre(made.id, of_new.id));
  EXPECT_THAT(ids({.status = "open"}), testing::IsEmpty());
  EXPECT_EQ(error_of(documents->accept(made.id, {})).code, ErrorCode::conflict);
  EXPECT_EQ(error_of(documents->accept(of_new.id, {})).code, ErrorCode::conflict);
  EXPECT_EQ(proposals->find(made.id)->status, Status::open) << "nobody has decided about it";
  ASSERT_TRUE(documents->remove("fresh"));
  EXPECT_THAT(ids({.status = "open"}), testing::ElementsAre(of_new.id));
  EXPECT_EQ(documents->accept(of_new.id, {})->revision.number, 2) << "it goes on after the removed one";
}

TEST_F(ProposalsTest, ThatChangeNothingAreAcceptedAsTheLastRevision) {
  ASSERT_TRUE(documents->put("task", prepared("task", 1)));
  const Proposal made = propose("agent", 2);
  EXPECT_EQ(documents->accept(made.id, {"Ada"})->revision.number, 2);
  EXPECT_EQ(proposals->find(made.id)->revision, 2);
  EXPECT_EQ(error_of(documents->accept(made.id, {})).code, ErrorCode::conflict) << "once";
}

TEST_F(ProposalsTest, OfSeveralWhoDecideAtOnceExactlyOneDoes) {
  for (int round = 0; round < 20; ++round) {
    const std::string name = "task" + std::to_string(round);
    ASSERT_TRUE(documents->put(name, kTask));
    const Proposal made = propose("agent", 1, name);
    std::atomic<int> accepted = 0, declined = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i) threads.emplace_back([&] { accepted += documents->accept(made.id, {"Ada"}) ? 1 : 0; });
    threads.emplace_back([&] { declined += proposals->decide(made.id, {.by = "Bob"}) ? 1 : 0; });
    for (std::thread& each : threads) each.join();
    EXPECT_EQ(accepted + declined, 1);
    EXPECT_EQ(documents->entry(name)->revision.number, 1 + accepted);
    EXPECT_EQ(proposals->find(made.id)->status, accepted == 1 ? Status::accepted : Status::declined);
  }
}

TEST_F(ProposalsTest, OfTwoOfOneRevisionOneIsAccepted) {
  const Proposal one = propose("agent");
  Proposal rival{.document = "task", .base = 1, .author = "rival", .created_ms = time};
  rival = proposals->add(rival, prepared("task", 1, R"({"rcm": 1, "root": {"state": "R", "doc": "rival"}})")).value();
  std::atomic<int> accepted = 0;
  std::vector<std::thread> threads;
  for (const std::int64_t id : {one.id, rival.id})
    threads.emplace_back([&, id] { accepted += documents->accept(id, {"Ada"}) ? 1 : 0; });
  for (std::thread& each : threads) each.join();
  EXPECT_EQ(accepted, 1);
  EXPECT_EQ(documents->entry("task")->revision.number, 2);
  EXPECT_EQ(ids({.status = "outdated"}).size(), 1U);
}

TEST_F(ProposalsTest, AreAcceptedWithTheirRevisionOrNotAtAllWhenThePowerIsLost) {
  const Proposal made = propose("agent");
  documents.reset();
  proposals.reset();  // closes the file, which takes over its log
  const std::filesystem::path disk = folder_ / "disk", after = folder_ / "after";
  std::filesystem::create_directories(disk);
  std::filesystem::create_directories(after);
  std::filesystem::copy_file(path(), disk / "race.sqlite");
  sqlite::FaultyVfs vfs;
  documents = Documents::open(disk / "race.sqlite").value();
  vfs.before_each([&](std::uint64_t operation) {
    for (const double kept : {0.0, 0.5, 1.0}) {
      vfs.lose_power(disk, after, kept, operation);
      const std::string left = after / "race.sqlite";
      const std::int64_t revision = Documents::open(left).value()->entry("task").value().revision.number;
      const Proposal found = Proposals::open(left).value()->find(made.id).value();
      EXPECT_EQ(found.status, revision == 2 ? Status::accepted : Status::open) << "before operation " << operation;
    }
  });
  ASSERT_TRUE(documents->accept(made.id, {"Ada"}));
  documents.reset();
  EXPECT_GT(vfs.operations(), 5U);
}

TEST_F(ProposalsTest, AreBounded) {
  for (std::int64_t i = 0; i < kMostProposalsOfPerson; ++i) propose("a~" + std::to_string(i));
  const auto refused = try_propose("a~other");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_EQ(refused.error().path, "author");
  EXPECT_TRUE(try_propose("ab")) << "somebody else, whose name begins so";
  ASSERT_TRUE(decide(ids({.most = 1}).front(), Status::withdrawn));
  propose("a");
  for (std::int64_t i = kMostProposalsOfPerson + 1; i < kMostOpenProposals; ++i) propose("p" + std::to_string(i));
  EXPECT_EQ(try_propose("nobody").error().code, ErrorCode::too_large);
  EXPECT_EQ(proposals->undecided()->size(), static_cast<std::size_t>(kMostOpenProposals));
  ASSERT_TRUE(documents->accept(ids({.status = "open", .most = 1}).front(), {"Ada"}));
  EXPECT_TRUE(try_propose("nobody", 2)) << "there is room again";
}

TEST_F(ProposalsTest, AreOfBoundedBytes) {
  const std::string half(static_cast<std::size_t>(kMostBytesOfPerson / 2), ' ');
  const auto add = [&](const std::string& author, const std::string& text) {
    return proposals->add({.document = "task", .base = 1, .author = author, .created_ms = time}, text);
  };
  const Proposal first = add("a", half).value();
  EXPECT_EQ(first.bytes, kMostBytesOfPerson / 2);
  ASSERT_TRUE(add("a~1", half));
  EXPECT_EQ(add("a", " ").error().path, "author");
  for (std::int64_t bytes = kMostBytesOfPerson; bytes < kMostOpenBytes; bytes += kMostBytesOfPerson / 2)
    ASSERT_TRUE(add("p" + std::to_string(bytes), half));
  const auto refused = add("b", " ");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_EQ(refused.error().path, "");
  EXPECT_THAT(refused.error().message, testing::HasSubstr("more than 64 MiB"));
  for (const std::int64_t id : ids({})) ASSERT_TRUE(decide(id, Status::declined));
  ASSERT_TRUE(decide(add("b", " ").value().id, Status::declined));
  EXPECT_EQ(proposals->find(first.id).error().code, ErrorCode::not_found) << "of the decided ones, the oldest go";
  EXPECT_EQ(ids({}).size(), static_cast<std::size_t>(kMostDecidedBytes) / half.size());
}

TEST_F(ProposalsTest, AreKeptOnceTheyAreDecidedTheLastOfThem) {
  const Proposal first = propose("a"), second = propose("a"), waits = propose("a");
  ASSERT_TRUE(decide(second.id, Status::declined));
  ASSERT_TRUE(decide(first.id, Status::declined));
  for (std::int64_t i = 2; i < kMostDecidedProposals; ++i) ASSERT_TRUE(decide(propose("b").id, Status::withdrawn));
  EXPECT_TRUE(proposals->find(second.id));
  ASSERT_TRUE(decide(propose("b").id, Status::withdrawn));
  EXPECT_EQ(proposals->find(second.id).error().code, ErrorCode::not_found) << "decided first";
  EXPECT_TRUE(proposals->find(first.id));
  EXPECT_TRUE(proposals->find(waits.id)) << "nobody has decided about it";
  time = 0;
  ASSERT_TRUE(decide(waits.id, Status::declined));
  EXPECT_TRUE(proposals->find(waits.id)) << "decided last, whatever the clock says";
}

TEST_F(ProposalsTest, HaveWordsOfBoundedLength) {
  Proposal long_note{.document = "task", .base = 1, .note = std::string(2001, 'n')};
  EXPECT_EQ(proposals->add(long_note, prepared("task", 1)).error().path, "note");
  long_note.note.pop_back();
  EXPECT_TRUE(proposals->add(long_note, prepared("task", 1)));
  const Proposal made = propose("agent");
  EXPECT_EQ(proposals->decide(made.id, {.reason = std::string(2001, 'r')}).error().path, "reason");
  EXPECT_TRUE(proposals->decide(made.id, {.reason = std::string(2000, 'r')}));
}

TEST_F(ProposalsTest, HaveNumbersThatNoneHadBefore) {
  const Proposal first = propose("a"), second = propose("a");
  EXPECT_EQ(first.id, 1000) << "the time";
  EXPECT_EQ(second.id, 1001) << "of the same time";
  time = 500;
  EXPECT_EQ(propose("a").id, 1002) << "also if the clock was wrong";
  time = 5000;
  EXPECT_EQ(propose("a").id, 5000);
}

TEST_F(ProposalsTest, AreListedInPages) {
  const Proposal one = propose("a"), other = propose("a", 0, "fresh"), two = propose("b"), three = propose("b");
  const ProposalPage page = proposals->list({.document = "task", .most = 2}).value();
  EXPECT_THAT(page.proposals, testing::ElementsAre(one, two));
  EXPECT_EQ(page.next, two.id);
  const ProposalPage last = proposals->list({.document = "task", .after = *page.next, .most = 2}).value();
  EXPECT_THAT(last.proposals, testing::ElementsAre(three));
  EXPECT_FALSE(last.next);
  EXPECT_THAT(ids({.document = "fresh"}), testing::ElementsAre(other.id));
}

TEST_F(ProposalsTest, AreNamedWhenTheyAreDamaged) {
  for (const char* damage : {"note = 'x'", "status = 'accepted'", "status = 'other'", "base = 3", "digest = x'00'",
                             "bytes = 1", "decided_by = 'Bob'", "text_digest = x'00'"}) {
    const Proposal made = propose("agent"), whole = propose("agent");
    const std::string where = " WHERE id = " + std::to_string(made.id);
    SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("UPDATE proposal SET " + (damage + where));
    EXPECT_EQ(proposals->find(made.id).error().code, ErrorCode::corrupt) << damage;
    EXPECT_EQ(proposals->find(made.id).error().path, "proposals/" + std::to_string(made.id));
    EXPECT_EQ(error_of(documents->accept(made.id, {})).code, ErrorCode::corrupt) << damage;
    const ProposalPage page = proposals->list({}).value();
    EXPECT_THAT(page.proposals, testing::ElementsAre(whole)) << damage;
    EXPECT_EQ(page.damaged.size(), 1U) << damage;
    SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("DELETE FROM proposal");
  }
  const Proposal made = propose("agent");
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("UPDATE proposal SET text = '{}'");
  EXPECT_EQ(proposals->read(made.id).error().code, ErrorCode::corrupt);
  EXPECT_EQ(error_of(documents->accept(made.id, {})).code, ErrorCode::corrupt);
  EXPECT_EQ(proposals->list({})->proposals.size(), 1U) << "a list reads no texts";
  EXPECT_TRUE(decide(made.id, Status::declined)) << "so that it does not wait for ever";
  EXPECT_EQ(proposals->find(made.id)->status, Status::declined);
}

}  // namespace
}  // namespace race::server
