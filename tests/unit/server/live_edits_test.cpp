// Cores that follow the edits of their documents: what is durable is what everyone sees, also when the disk fails.
#include "server/execution/live_edits.h"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"
#include "tests/unit/server/hosted_cores.h"

namespace race::server {
namespace {

constexpr const char* kDocument = R"({"rcm": 1, "name": "live", "root": {"state": "Root",
  "variables": [{"name": "n", "initial": 0}],
  "children": [{"state": "A", "ports": [{"name": "next", "when": "False", "to": "B"}]}, {"state": "B"}], "first": "A"}})";

struct LiveEditsOfCores : HostedCores {
  void SetUp() override {
    begin_server();
    documents = Documents::open(folder.store()).value();
    edits = std::make_unique<LiveEdits>(*documents, *cores);
    ASSERT_TRUE(documents->put("live", kDocument));
    core = cores->create(documents->get("live").value(), {}).value();
    ASSERT_TRUE(core->start());
    ASSERT_TRUE(core->set_live(true));
  }
  void TearDown() override {
    edits->close();
    core.reset();
    end_server();  // a strand may still tell it of a stale edit
    edits.reset();
  }

  // Stores the document with one more variable; its revision.
  std::int64_t put_variable(const std::string& name) {
    static const std::string kVariables = R"("variables":[)";
    return put_with({{kVariables, kVariables + R"({"name":")" + name + R"(","initial":1},)"}});
  }
  // Stores the document with other words; its revision.
  std::int64_t put_with(const std::vector<std::pair<std::string, std::string>>& words) {
    std::string text = to_json(documents->entry("live").value().document);
    for (const auto& [from, to] : words) {
      EXPECT_NE(text.find(from), std::string::npos) << from;
      text.replace(text.find(from), from.size(), to);
    }
    return documents->put("live", text).value().revision.number;
  }
  Value at(std::int64_t revision) {
    return wait(*core, [revision](const Value& info) {
      return *info.find("revision") == Value(revision) && !info.find("waiting_edit");
    });
  }
  std::vector<std::string> kinds() {
    std::vector<std::string> kinds;
    const std::uint64_t steps = runs->get(core->run_id())->steps;
    const auto entries = runs->entries(core->run_id(), 1, steps).value();
    for (const execution::JournalEntry& entry : entries)
      kinds.push_back(execution::input_json(entry).find("kind")->as_string());
    return kinds;
  }
  static std::int64_t revision_of(const Value& info) { return info.find("revision")->as_integer(); }

  std::unique_ptr<Documents> documents;
  std::unique_ptr<LiveEdits> edits;
  std::shared_ptr<Core> core;
};

TEST_F(LiveEditsOfCores, AnEditIsSeenByNobodyBeforeItsEntryIsDurable) {
  const std::int64_t revision = put_variable("x");
  const auto file = sqlite::open(folder.store());
  auto busy = std::make_unique<sqlite::WriteTransaction>(*file);  // the writer stands in line
  edits->changed("live");
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(revision_of(core->info()), revision - 1);
  busy.reset();
  EXPECT_EQ(at(revision).find("model")->as_integer(), 2);
  EXPECT_EQ(kinds(), (std::vector<std::string>{"start", "edit"}));
}

TEST_F(LiveEditsOfCores, AnEditThatCannotBeStoredHasNotHappenedAndComesAgain) {
  const std::int64_t revision = put_variable("x");
  const auto before = core->model().program;
  disk.fail_at(1, sqlite::FaultyVfs::Fault::full, true);
  edits->changed("live");
  const Value info = wait(*core, [](const Value& now) { return now.find("status")->as_string() == "interrupted"; });
  EXPECT_EQ(revision_of(info), revision - 1);
  disk.repair();
  EXPECT_EQ(status(core->resume()), "running");
  EXPECT_EQ(at(revision).find("status")->as_string(), "running");
  EXPECT_NE(core->model().program, before);
  EXPECT_EQ(kinds(), (std::vector<std::string>{"start", "edit"}));
}

TEST_F(LiveEditsOfCores, OneThatWaitsForAModelThatIsNoMoreIsMadeAnew) {
  const std::int64_t first = put_variable("x");
  const Value paused = core->pause().value();
  edits->changed("live");
  wait(*core, [](const Value& now) { return now.find("waiting_edit") != nullptr; });
  disk.fail_at(1, sqlite::FaultyVfs::Fault::full, true);
  ASSERT_TRUE(core->resume());
  wait(*core, [](const Value& now) { return now.find("status")->as_string() == "interrupted"; });
  disk.repair();
  const std::int64_t second = put_variable("y");
  edits->changed("live");
  wait(*core, [second](const Value& now) {
    const Value* edit = now.find("waiting_edit");
    return edit && *edit->find("revision") == Value(second);
  });
  ASSERT_TRUE(core->resume());
  at(second);
  EXPECT_EQ(core->force({semantics::Force::Scope::var, "Root", "x", 5})->find("revision")->as_integer(), second);
  EXPECT_GT(second, first);
  EXPECT_EQ(kinds(), (std::vector<std::string>{"start", "edit", "force"}));
}

TEST_F(LiveEditsOfCores, ManyEditsLeadToTheLast) {
  std::int64_t revision = 0;
  for (int i = 0; i < 30; ++i) {
    revision = put_variable("x" + std::to_string(i));
    edits->changed("live");
  }
  at(revision);
  const Value state = *core->state()->find("state");
  EXPECT_EQ(state.find("variables")->find("Root")->as_dict().size(), 31U);
  const RunRecord run = runs->get(core->run_id()).value();
  execution::Replay replay(core->header(), runs->source(core->run_id()));
  EXPECT_EQ(replay.after(run.steps)->run().state_json(), state);
}

TEST_F(LiveEditsOfCores, OnePausedInAMacroStepGetsItAtItsEnd) {
  ASSERT_TRUE(core->pause());
  ASSERT_TRUE(core->set_breakpoints({{execution::Goal::Kind::entered, {}, "Root/B"}}));
  ASSERT_TRUE(core->force({semantics::Force::Scope::port, "Root/A", "next"}));
  EXPECT_NE(core->info().find("micro")->as_integer(), 0);
  EXPECT_EQ(core->force({semantics::Force::Scope::var, "Root", "n", 1}).error().code, ErrorCode::conflict);
  const std::int64_t revision = put_variable("x");
  edits->changed("live");
  const Value held = wait(*core, [](const Value& now) { return now.find("waiting_edit") != nullptr; });
  EXPECT_EQ(held.find("waiting_edit")->find("waits")->as_list().size(), 0U);
  ASSERT_TRUE(core->resume());
  EXPECT_EQ(at(revision).find("step")->as_integer(), 3);
}

TEST_F(LiveEditsOfCores, ABreakpointByIdFollowsItsStateAndOneByPathIsOfWhatIsThere) {
  const execution::Goal::Kind entered = execution::Goal::Kind::entered;
  const std::string id = [this] {
    const Value stored = documents->entry("live").value().document;
    return stored.find("root")->find("children")->as_list()[1].find("meta")->find("id")->as_string();
  }();
  ASSERT_TRUE(core->set_breakpoints({{entered, id, ""}, {entered, {}, "Root/B"}}));
  const std::int64_t renamed = put_with({{R"("to":"B")", R"("to":"C")"}, {R"("state":"B")", R"("state":"C")"}});
  edits->changed("live");
  EXPECT_EQ(*at(renamed).find("breakpoints"), parse_json(R"([{"when": "entered", "id": ")" + id + R"("}])"));
  ASSERT_TRUE(core->set_breakpoints({{entered, {}, "Root/C"}}));
  const std::int64_t replaced =
      put_with({{R"("state":"C")", R"("ports":[{"name":"on","to":"C","when":"False"}],"state":"D")"},
                {R"("to":"C")", R"("to":"D")"},
                {R"("children":[)", R"("children":[{"state":"C"},)"}});
  edits->changed("live");
  EXPECT_EQ(at(replaced).find("breakpoints")->as_list().size(), 1U);
  const Value entered_d = core->force({semantics::Force::Scope::port, "Root/A", "next"}).value();
  EXPECT_FALSE(entered_d.find("paused")->as_bool()) << "no breakpoint that is listed is of this state";
  const Value entered_c = core->force({semantics::Force::Scope::port, "Root/D", "on"}).value();
  EXPECT_TRUE(entered_c.find("paused")->as_bool());
}

TEST_F(LiveEditsOfCores, NoEditWaitsForARunThatIsOver) {
  ASSERT_TRUE(core->pause());
  put_variable("x");
  edits->changed("live");
  wait(*core, [](const Value& now) { return now.find("waiting_edit") != nullptr; });
  const Value ended = core->stop().value();
  EXPECT_EQ(ended.find("status")->as_string(), "aborted");
  EXPECT_EQ(ended.find("waiting_edit"), nullptr);
}

TEST_F(LiveEditsOfCores, NothingIsHeardOfARemovedCoreWhoseEditWasOnItsWay) {
  const auto ready = cores->create(documents->get("live").value(), {}).value();
  ASSERT_TRUE(ready->set_live(true));
  const LiveEdit edit = [&] {
    put_variable("x");
    return cores->edit_for(*ready, documents->get("live").value()).value();
  }();
  ASSERT_TRUE(cores->remove(ready->id()));
  const auto before = all_told();
  ready->follow(edit);
  ready->refuse_edit(edit.revision, {{ErrorCode::type, "of another service", "services/s"}});
  ASSERT_TRUE(ready->native()) << "its strand has come so far";
  EXPECT_EQ(all_told(), before);
}

TEST_F(LiveEditsOfCores, NothingIsForcedInAnInterruptedCore) {
  disk.fail_at(1, sqlite::FaultyVfs::Fault::full, true);
  EXPECT_EQ(core->force({semantics::Force::Scope::var, "Root", "n", 1}).error().code, ErrorCode::storage);
  disk.repair();
  EXPECT_EQ(core->force({semantics::Force::Scope::var, "Root", "n", 1}).error().code, ErrorCode::conflict);
  ASSERT_TRUE(core->resume());
  EXPECT_TRUE(core->force({semantics::Force::Scope::var, "Root", "n", 1}));
}

}  // namespace
}  // namespace race::server
