#include "server/execution/cores.h"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <future>

#include "core/rcm/document.h"
#include "core/rsm/document.h"
#include "server/runs/run_file.h"
#include "services/sqlite/file.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/server/bench.h"

namespace race::server {
namespace {

// A service that does nothing.
class Idle final : public services::Component {
 public:
  explicit Idle(const char* operation) : model_(rsm::read_service_text(text_with(operation), "idle").value()) {}
  const rsm::Service& model() const override { return model_; }
  void call(const services::Call&) override {}

 private:
  static std::string text_with(const std::string& operation) {
    return R"({"operations": [{"name": ")" + operation + R"("}], "events": []})";
  }
  const rsm::Service model_;
};

struct CoresTest : testing::Test, CoreWatcher {
  // Not by the destructor: threads call this watcher until then.
  void TearDown() override {
    store.writer->close();
    pool.reset();
  }

  void core_changed(const std::string& id, Value) override {
    if (!heard.exchange(true)) found.set_value(cores.find(id).has_value());
  }
  void core_removed(const std::string& id) override {
    removed.push_back(id);
    if (when_removed) when_removed();
  }
  void state_replaced(const std::string&, Value) override {}
  void state_snapshot(const std::string&, Value) override {}
  void state_changed(const std::string&, Value) override {}
  void derivation_snapshot(const std::string&, Value) override {}
  void derived(const std::string&, Value) override {}
  void run_lost(const std::string& id, const std::string& why) override { said.push_back(id + ": " + why); }
  void printed(const std::string& id, const std::string& text) override {
    if (text != "busy") return said.push_back(id + ": " + text);
    busy.set_value();
    go_on.get_future().wait();
  }

  std::atomic<bool> heard{false};
  std::promise<bool> found;
  std::promise<void> busy, go_on;  // a core that prints "busy" is, until it goes on
  std::vector<std::string> removed, said;
  std::function<void()> when_removed;
  services::WorldClock clock;
  services::WorkQueue queue;
  NoObserver observer;
  services::Host host{clock, observer};
  std::unique_ptr<Pool> pool = std::make_unique<Pool>(2);
  TemporaryStore store;
  Deadlines deadlines;
  Worker replays{deadlines};
  Cores cores{*pool, host, *this, *store.runs, *store.writer, replays, deadlines};
};

TEST_F(CoresTest, WhoHearsOfACoreCanFindIt) {
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  ASSERT_TRUE(cores.create({"r", 1, document}, {}));
  EXPECT_TRUE(found.get_future().get());
}

TEST_F(CoresTest, ARemovedCoreIsReportedAndCannotBeFound) {
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  const std::string id = cores.create({"r", 1, document}, {}).value()->id();
  EXPECT_TRUE(cores.remove(id));
  EXPECT_EQ(removed, std::vector{id});
  EXPECT_EQ(cores.find(id).error().code, ErrorCode::not_found);
  EXPECT_EQ(cores.remove(id).error().code, ErrorCode::not_found);
}

TEST_F(CoresTest, WhereThereAre128TheOldestThatIsOverMakesWay) {
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  const auto create = [&] { return cores.create({"r", 1, document}, {}); };
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < Cores::kMost; ++i) ids.push_back(create().value()->id());
  EXPECT_EQ(create().error().front().code, ErrorCode::conflict) << "none has begun, so none is over";
  for (const std::size_t i : {90U, 40U}) {
    ASSERT_TRUE(cores.find(ids[i]).value()->start());
    ASSERT_TRUE(cores.find(ids[i]).value()->stop());
  }
  EXPECT_TRUE(create());
  EXPECT_EQ(removed, std::vector{ids[40]});
  EXPECT_EQ(cores.find(ids[40]).error().code, ErrorCode::not_found);
  EXPECT_EQ(store.runs->get(std::stoll(ids[40]))->status, "aborted") << "its run stays";
  EXPECT_TRUE(create());
  EXPECT_EQ(removed, (std::vector{ids[40], ids[90]}));
  EXPECT_EQ(create().error().front().code, ErrorCode::conflict);
  EXPECT_EQ(cores.all().size(), Cores::kMost);
}

// A process may bring another RSM at any time.
TEST_F(CoresTest, ARunIsStoredWithTheRsmsThatItsProgramWasCheckedAgainst) {
  const auto document =
      rcm::read_document_text(R"json({"rcm": 1, "root": {"state": "R", "entry": "svc.idle.go()"}})json").value();
  host.declare("idle", "idle", queue);
  host.attach("idle", std::make_unique<Idle>("go"));
  const auto describe = [&] { host.describe("idle", "idle", std::make_unique<Idle>("other")); };
  const auto operation = [&](RunId run) {
    return services_of(run, *store.runs).value().at("idle").operations.front().name;
  };
  const auto loaded = cores.create({"r", 1, document}, {}).value();
  while (cores.all().size() < Cores::kMost) ASSERT_TRUE(cores.create({"r", 1, document}, {}));
  const auto over = cores.all()[1];
  ASSERT_TRUE(over->start());
  ASSERT_TRUE(over->stop());
  when_removed = describe;  // within create(), as one makes way
  EXPECT_EQ(operation(cores.create({"r", 1, document}, {}).value()->run_id()), "go");
  host.describe("idle", "idle", std::make_unique<Idle>("go"));

  std::promise<void> go;
  const auto going = go.get_future().share();
  for (int threads = 0; threads < 2; ++threads) pool->post([going] { going.wait(); });
  std::promise<bool> done;
  cores.load(loaded->id(), {"r", 2, document}, {}, {}, [&](const auto& core) { done.set_value(core.has_value()); });
  describe();
  go.set_value();
  ASSERT_TRUE(done.get_future().get());
  EXPECT_EQ(operation(loaded->run_id()), "go");
}

TEST_F(CoresTest, AModelThatIsLoadedTakesThePlaceOfOneThatHasNotBegun) {
  const auto first =
      rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R", "parameters": [{"name": "n"}]}})").value();
  const auto second = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "S"}})").value();
  const std::string id = cores.create({"r", 1, first}, Dict{{"n", 1}}).value()->id();
  using enum execution::Goal::Kind;
  ASSERT_TRUE(cores.find(id).value()->pause());
  ASSERT_TRUE(cores.find(id).value()->set_breakpoints({{entered, {}, "R"}}));
  ASSERT_TRUE(cores.find(id).value()->set_live(true));
  ASSERT_TRUE(cores.load(id, {"s", 2, second}, {}));
  const auto core = cores.find(id).value();
  const Value info = core->info();
  EXPECT_EQ(info.find("document")->as_string(), "s");
  EXPECT_EQ(info.find("revision")->as_integer(), 2);
  EXPECT_TRUE(info.find("live")->as_bool()) << "it is shown so from the first moment";
  EXPECT_TRUE(info.find("paused")->as_bool()) << "who paused it did not say that it may go";
  EXPECT_TRUE(info.find("breakpoints")->as_list().empty()) << "there is no R any more";
  EXPECT_EQ(store.runs->get(core->run_id())->document, "s");
  EXPECT_EQ(cores.all().size(), 1U);
  ASSERT_TRUE(core->start());
  EXPECT_EQ(cores.load(id, {"r", 1, first}, Dict{{"n", 1}}).error().front().code, ErrorCode::conflict);
}

TEST_F(CoresTest, ARunThatIsDamagedIsNamedAndTheOthersAreHostedAgain) {
  const execution::Journal journal = execution::small_journal();
  for (int i = 0; i < 3; ++i) store.runs->create({"small", 1, journal.header, {}}, i).value();
  sqlite::open(store.folder.store())->exec("UPDATE run SET steps = 7 WHERE id = 2");
  ASSERT_TRUE(cores.recover());
  EXPECT_EQ(cores.all().size(), 2U);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].substr(0, 37), "2: cannot be rebuilt: runs/2: corrupt");
  EXPECT_EQ(store.runs->get(2).error().code, ErrorCode::corrupt) << "it stays";
}

TEST_F(CoresTest, ARunThatNeverBeganIsRemovedWithItsCore) {
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  const auto never = cores.create({"r", 1, document}, {}).value(), begun = cores.create({"r", 1, document}, {}).value();
  ASSERT_TRUE(begun->start());
  ASSERT_TRUE(cores.remove(never->id()));
  ASSERT_TRUE(cores.remove(begun->id()));
  EXPECT_EQ(store.runs->get(never->run_id()).error().code, ErrorCode::not_found);
  EXPECT_EQ(store.runs->get(begun->run_id())->status, "aborted");
}

TEST_F(CoresTest, ALongReplayDelaysNoCore) {
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  const auto replayed = cores.create({"r", 1, document}, {}).value(),
             other = cores.create({"r", 1, document}, {}).value();
  ASSERT_TRUE(replayed->start());
  std::promise<void> begun, over;
  std::promise<Expected<bool>> long_replay;
  replays.ask<bool>(
      [&](const Stop&) {
        begun.set_value();
        over.get_future().wait();
        return true;
      },
      {std::chrono::seconds(60), {ErrorCode::too_large, ""}}, std::make_shared<Stop>(false),
      [&](Expected<bool> done) { long_replay.set_value(std::move(done)); });
  begun.get_future().wait();
  auto derived = std::async(std::launch::async, [&] { return replayed->derivations(1, 1).has_value(); });
  EXPECT_TRUE(other->start());
  EXPECT_EQ(derived.wait_for(std::chrono::milliseconds(100)), std::future_status::timeout) << "not on the worker";
  over.set_value();
  EXPECT_TRUE(long_replay.get_future().get());
  EXPECT_TRUE(derived.get());
}

TEST_F(CoresTest, ABusyCoreKeepsNoOtherFromBeingLoadedOrRemoved) {
  const auto task =
      rcm::read_document_text(R"json({"rcm": 1, "root": {"state": "R", "entry": "print('busy')"}})json").value();
  const auto quiet = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  const std::string at_work = cores.create({"r", 1, task}, {}).value()->id();
  const std::string first = cores.create({"r", 1, quiet}, {}).value()->id(),
                    second = cores.create({"r", 1, quiet}, {}).value()->id();
  cores.find(at_work).value()->start([](const Expected<Value>&) {});
  busy.get_future().wait();
  std::promise<Expected<std::shared_ptr<Core>>> gone;
  cores.remove(at_work, [&](Expected<std::shared_ptr<Core>> core) { gone.set_value(std::move(core)); });
  EXPECT_EQ(cores.remove(at_work).error().code, ErrorCode::conflict) << "it is being removed";
  EXPECT_TRUE(cores.load(first, {"s", 2, quiet}, {}));
  EXPECT_TRUE(cores.remove(second));
  go_on.set_value();
  EXPECT_TRUE(gone.get_future().get());
  EXPECT_FALSE(cores.find(at_work));
}

TEST_F(CoresTest, ACoreThatFollowsItsDocumentDoesFromTheFirstMoment) {
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  const auto core = cores.create({"r", 1, document}, {}, true).value();
  EXPECT_TRUE(core->is_live());
  EXPECT_TRUE(core->info().find("live")->as_bool());
}

}  // namespace
}  // namespace race::server
