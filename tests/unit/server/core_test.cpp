// What watchers of a core are told, wherever in a macro step they come.
#include "server/execution/core.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <new>
#include <set>
#include <thread>

#include "core/rcm/document.h"
#include "core/rcm/native.h"
#include "core/rcm/translate.h"
#include "tests/unit/server/bench.h"

namespace race::server {
namespace {

// States that follow one another without waiting: one macro step of several turns of the strand.
constexpr int kStates = 1200;

std::string long_step() {
  const auto state = [](int i, const std::string& ports) {
    const std::string number = std::to_string(i);
    return R"({"state": "S)" + number + R"(", "entry": "var.n = )" + number + R"(\nprint()" + number +
           R"()\nfor i in range(20):\n    var.i = i", "ports": [)" + ports + "]}";
  };
  std::string text = R"({"rcm": 1, "root": {"state": "R", "first": "S0", "children": [)";
  for (int i = 0; i < kStates; ++i)
    text += state(i, R"({"name": "next", "when": "True", "to": "S)" + std::to_string(i + 1) + R"("})") + ", ";
  return text + state(kStates, "") + "]}}";
}

// What a client holds: the last snapshot and what came after it.
struct View {
  explicit View(const Value& snapshot) {
    const Value& state = *snapshot.find("state");
    for (const char* field : {"active", "ports"})
      for (const Value& name : state.find(field)->as_list()) set(field).insert(name.as_string());
    for (const auto& [path, entries] : state.find("variables")->as_dict())
      for (const auto& [name, value] : entries.as_dict()) variables[path.as_string()][name.as_string()] = value;
  }
  void apply(const Value& delta) {
    for (const char* field : {"active", "ports"})
      for (const auto& [name, on] : delta.find(field)->as_dict()) {
        if (on.as_bool()) set(field).insert(name.as_string());
        if (!on.as_bool()) set(field).erase(name.as_string());
      }
    for (const auto& [path, entries] : delta.find("variables")->as_dict())
      for (const auto& [name, value] : entries.as_dict()) variables[path.as_string()][name.as_string()] = value;
  }
  bool operator==(const View&) const = default;

  std::set<std::string>& set(std::string_view field) { return field == "active" ? active : ports; }
  std::set<std::string> active, ports;
  std::map<std::string, std::map<std::string, Value>> variables;
};

struct CoreTest : testing::Test, CoreWatcher {
  /// Starts the core, which stands still within its step from its print of 150 on, until `go_on`.
  void start_and_block(std::promise<void>& go_on) {
    auto busy = std::make_shared<std::promise<void>>();
    on_print = [busy, &go_on](const std::string& text) {
      if (text != "150") return;
      busy->set_value();
      go_on.get_future().wait();
    };
    ASSERT_TRUE(core->start());
    busy->get_future().wait();
  }
  CoreTest() {
    const rcm::Document document = rcm::read_document_text(long_step()).value();
    const rcm::NativeModel native = rcm::translate(document).value();
    execution::JournalHeader header{
        rcm::write_native(document, native), semantics::Program::build(native, {}).value(), {}, {}};
    header.native.freeze();
    RunRecord run = store.runs->create({"long", 1, header, {}}, 0).value();
    core = Core::create(std::move(run), std::move(header),
                        {*pool, host, *this, *store.runs, *store.writer, replays, deadlines, watchdog})
               .value();
  }
  // Not by the destructor: threads call this watcher until then.
  void TearDown() override {
    store.writer->close();
    pool.reset();
  }

  // On the core's strand.
  void core_changed(const std::string&, Value json) override {
    last = json;
    if (on_status && json.find("status")->as_string() == "running") std::exchange(on_status, nullptr)();
  }
  void core_removed(const std::string&) override {}
  void state_replaced(const std::string&, Value) override {}
  void state_snapshot(const std::string&, Value json) override {
    views.emplace_back(json);
    micro.push_back(json.find("core")->find("micro")->as_integer());
    if (micro.back() > 0 && on_view_within) std::exchange(on_view_within, nullptr)();
  }
  void state_changed(const std::string&, Value delta) override {
    for (View& view : views) view.apply(delta);
    for (const Value& port : delta.find("fired")->as_list()) fired.push_back(port.as_string());
    last = *delta.find("core");
    EXPECT_EQ(core->info(), last) << "who hears of it and asks at once is told no less";
  }
  void derivation_snapshot(const std::string&, Value) override {}
  void derived(const std::string&, Value) override {}
  void run_lost(const std::string&, const std::string&) override {}
  void printed(const std::string&, const std::string& text) override {
    if (on_print) on_print(text);
  }

  // Paused before its first step, and watched.
  void hold_and_watch() {
    core->watch_state();
    ASSERT_TRUE(core->pause());
    ASSERT_TRUE(core->start());
  }
  // The core after a pause that was asked for in the first turns of the macro step that `begin` lets begin.
  Value paused_within(const std::function<void()>& begin) {
    std::promise<Expected<Value>> paused;
    // Its first turn is over when the core is said to run, and the next has been posted.
    on_status = [this] { core->watch_state(); };
    on_view_within = [&] { core->pause([&](Expected<Value> value) { paused.set_value(std::move(value)); }); };
    begin();
    return paused.get_future().get().value();
  }
  Value wait_until_paused() {
    Value info;
    do info = *core->state()->find("core");
    while (!info.find("paused")->as_bool());
    return info;
  }
  void wait_for_the_end_of_the_macro_step() {
    while (core->state()->find("core")->find("micro")->as_integer() > 0) {
    }
  }
  void expect_that_all_have_the_state() {
    const Value state = core->state().value();
    ASSERT_FALSE(views.empty());
    for (std::size_t i = 0; i < views.size(); ++i) EXPECT_EQ(views[i], View(state)) << "watcher " << i;
    EXPECT_EQ(last, *state.find("core"));
  }

  services::WorldClock clock;
  NoObserver observer;
  services::Host host{clock, observer};
  TemporaryStore store;
  Deadlines deadlines;
  Worker replays{deadlines};
  Watchdog watchdog;
  std::unique_ptr<Pool> pool = std::make_unique<Pool>(1);
  std::deque<View> views;
  std::vector<std::int64_t> micro;  // of the snapshots
  std::vector<std::string> fired;   // as all deltas told
  Value last;                       // the core as it was told last
  std::function<void()> on_status, on_view_within;
  std::function<void(const std::string&)> on_print;
  std::shared_ptr<Core> core;
};

TEST_F(CoreTest, AWatcherWhoComesBetweenMicroStepsCostsNobodyAChange) {
  hold_and_watch();
  for (int i = 0; i < 7; ++i) ASSERT_TRUE(core->step({execution::Goal::Kind::micro}));
  core->watch_state();
  expect_that_all_have_the_state();
  ASSERT_TRUE(core->step({execution::Goal::Kind::micro}));
  core->watch_state();
  ASSERT_TRUE(core->step({execution::Goal::Kind::macro}));
  ASSERT_TRUE(core->pause());
  ASSERT_TRUE(core->step({execution::Goal::Kind::macro}));
  wait_for_the_end_of_the_macro_step();
  EXPECT_EQ(micro, (std::vector<std::int64_t>{0, 7, 8}));
  expect_that_all_have_the_state();
}

TEST_F(CoreTest, WhatThrowsInterruptsTheRunWhichIsRebuiltAndGoesOn) {
  bool thrown = false;
  on_print = [&](const std::string& text) {
    if (text == "150" && !std::exchange(thrown, true)) throw std::bad_alloc();
  };
  const auto status = [this] { return core->info().find("status")->as_string(); };
  std::ignore = core->start();
  while (status() != "interrupted") std::this_thread::yield();
  const Value interruption = *core->info().find("interruption");
  EXPECT_EQ(interruption.find("reason")->as_string(), "failure");
  EXPECT_THAT(interruption.find("message")->as_string(), testing::HasSubstr("a step failed: std::bad_alloc"));
  while (!core->resume()) std::this_thread::yield();  // until its journal has what it had handed over
  while (status() == "running" && core->info().find("micro")->as_integer() > 0) std::this_thread::yield();
  EXPECT_NE(status(), "interrupted");
}

TEST_F(CoreTest, HoweverOftenItsStateIsAskedForOneSnapshotIsMade) {
  std::promise<void> busy, go_on;
  on_status = [this] { core->watch_state(); };
  on_view_within = [&] {
    busy.set_value();
    go_on.get_future().wait();
  };
  core->watch_state();
  ASSERT_TRUE(core->start());
  busy.get_future().wait();
  for (int i = 0; i < 1000; ++i) core->watch_state();
  go_on.set_value();
  wait_for_the_end_of_the_macro_step();
  EXPECT_EQ(micro.size(), 3U);
  expect_that_all_have_the_state();
}

TEST_F(CoreTest, AWatcherWhoComesBetweenTheTurnsOfAMacroStepCostsNobodyAChange) {
  core->watch_state();
  // Its first turn has been posted when a core is said to run: this comes between that and the next.
  on_status = [this] { core->watch_state(); };
  ASSERT_TRUE(core->start());
  wait_for_the_end_of_the_macro_step();
  ASSERT_EQ(micro.size(), 2U);
  EXPECT_GT(micro[1], 0) << "not within the macro step";
  expect_that_all_have_the_state();
  ASSERT_EQ(fired.size(), static_cast<std::size_t>(kStates)) << "a port was told twice or not at all";
  EXPECT_EQ(fired.front(), "R/S0.next");
  EXPECT_EQ(fired.back(), "R/S" + std::to_string(kStates - 1) + ".next");
}

TEST_F(CoreTest, APauseWithinAMacroStepTellsWhatWasDoneOfIt) {
  hold_and_watch();
  const Value held = paused_within([this] {
    ASSERT_TRUE(core->step({execution::Goal::Kind::left, {}, "R/S" + std::to_string(kStates)}));
  });
  EXPECT_TRUE(held.find("paused")->as_bool());
  EXPECT_GT(held.find("micro")->as_integer(), 0) << "not within the macro step";
  expect_that_all_have_the_state();
  core->watch_state();
  expect_that_all_have_the_state();
}

TEST_F(CoreTest, APauseOfARunWaitsForTheEndOfTheMacroStep) {
  core->watch_state();
  const Value held = paused_within([this] { ASSERT_TRUE(core->start()); });
  EXPECT_TRUE(held.find("paused")->as_bool());
  EXPECT_EQ(held.find("micro")->as_integer(), 0);
  EXPECT_EQ(held.find("step")->as_integer(), 1);
  expect_that_all_have_the_state();
}

TEST_F(CoreTest, AQuestionAboutThePastDoesNotWaitForTheCore) {
  std::promise<void> go_on;
  start_and_block(go_on);
  EXPECT_EQ(core->position().value(), 1U) << "as far as it was told";
  EXPECT_EQ(core->derivations(1, 1).value().find("steps")->as_list().size(), 1U);
  EXPECT_EQ(core->derivations(2, 2).error().code, ErrorCode::out_of_range);
  go_on.set_value();
}

TEST_F(CoreTest, ACommandThatItDoesNotBeginInTimeIsRefusedAndNeverExecuted) {
  std::promise<void> go_on;
  start_and_block(go_on);
  std::promise<Expected<Value>> paused;
  core->pause([&](Expected<Value> value) { paused.set_value(std::move(value)); });
  EXPECT_EQ(paused.get_future().get().error().code, ErrorCode::unavailable);
  go_on.set_value();
  wait_for_the_end_of_the_macro_step();
  EXPECT_FALSE(core->info().find("paused")->as_bool());
}

TEST_F(CoreTest, AStepThatWaitsForAnInputIsPausedAndCanBeReplaced) {
  hold_and_watch();
  const auto expect = [](const Expected<Value>& json, bool paused, bool stepping) {
    ASSERT_TRUE(json) << json.error().message;
    EXPECT_EQ(json->find("paused")->as_bool(), paused);
    EXPECT_EQ(json->find("stepping")->as_bool(), stepping);
  };
  expect(core->step({execution::Goal::Kind::micro}), true, false);
  expect(core->resume(), false, false);
  wait_for_the_end_of_the_macro_step();
  expect(core->pause(), true, false);
  expect(core->step({execution::Goal::Kind::macro}), true, true);
  expect(core->step({execution::Goal::Kind::left, {}, "R"}), true, true);
  expect(core->info(), true, true);
  expect(core->pause(), true, false);
  expect(core->step({execution::Goal::Kind::micro}), true, true);
  expect(core->resume(), false, false);
  EXPECT_EQ(core->step({execution::Goal::Kind::micro}).error().code, ErrorCode::conflict);
}

TEST_F(CoreTest, ABreakpointPausesWithinAnyTurnOfAMacroStep) {
  hold_and_watch();
  const auto state = [](int i) { return "R/S" + std::to_string(i); };
  using enum execution::Goal::Kind;
  const auto set =
      core->set_breakpoints({{entered, {}, state(1)}, {left, {}, state(200)}, {fired, {}, state(390) + ".next"}});
  ASSERT_TRUE(set) << set.error().message;
  for (const int micro : {3, 402, 782}) {
    ASSERT_TRUE(core->resume());
    EXPECT_EQ(wait_until_paused().find("micro")->as_integer(), micro);
    expect_that_all_have_the_state();
  }
  EXPECT_EQ(core->set_breakpoints({{entered, {}, state(1)}, {entered, {}, "R/S"}}).error().path, "breakpoints/1/path");
  EXPECT_EQ(core->info().find("breakpoints")->as_list().size(), 3U) << "a refused list replaces nothing";
}

TEST_F(CoreTest, StopsWithoutPausingAtABreakpoint) {
  using execution::Goal;
  hold_and_watch();
  // What is left of the macro step is little: a stop waits only a short time for it.
  ASSERT_TRUE(core->step({Goal::Kind::entered, {}, "R/S" + std::to_string(kStates - 20)}));
  wait_until_paused();
  ASSERT_TRUE(core->set_breakpoints({{Goal::Kind::entered, {}, "R/S" + std::to_string(kStates - 10)}}));
  const auto stopped = core->stop();
  ASSERT_TRUE(stopped) << stopped.error().message;
  EXPECT_EQ(stopped->find("status")->as_string(), "aborted");
  EXPECT_EQ(fired.size(), static_cast<std::size_t>(kStates)) << "the open macro step is completed first";
}

}  // namespace
}  // namespace race::server
