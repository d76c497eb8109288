// Macro steps that compute for long: they hold up nobody, end by their deadline, and can be stopped.
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <thread>

#include "core/rcm/document.h"
#include "tests/unit/server/hosted_cores.h"

namespace race::server {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

// With t.spin, two states follow each other for 10 000 micro steps, each with conditions that compute for some
// milliseconds: longer than anybody waits, and all within the budgets. t.tick is counted.
constexpr const char* kSpinning = R"json({"rcm": 1, "root": {"state": "R", "first": "Idle",
  "results": [{"name": "ticks", "initial": 0}], "entry": "svc.t.move()",
  "actions": [{"when": "svc.t.tick", "do": "res.ticks += 1"}],
  "children": [
    {"state": "Idle", "ports": [{"name": "go", "when": "svc.t.spin", "to": "A"}]},
    {"state": "A", "ports": [{"name": "p", "when": "len([i for i in range(150000)]) > 0", "to": "B"}]},
    {"state": "B", "ports": [{"name": "p", "when": "len([i for i in range(150000)]) > 0", "to": "A"}]}]}})json";

struct LongSteps : HostedCores {
  std::shared_ptr<Core> core(milliseconds longest_step = milliseconds(10'000), const char* first = "Idle") {
    static constexpr const char* kService = R"({"operations": [{"name": "move"}, {"name": "halt", "safe": true}],
      "events": [{"name": "spin"}, {"name": "tick"}]})";
    const auto header = execution::journal_of(rcm::read_document_text(with_first(first)).value(),
                                              {{"t", rsm::read_service_text(kService, "t").value()}})
                            .header;
    RunRecord run = runs->create({"spin", 1, header, {}}, 0).value();
    return Core::create(std::move(run), header,
                        {*pool, host, *this, *runs, *writer, replays, deadlines, watchdog, longest_step})
        .value();
  }
  // In a long macro step, a moment after it has begun.
  std::shared_ptr<Core> spinning_core() {
    auto spinning = core();
    EXPECT_TRUE(spinning->start());
    happen(*spinning, "spin");
    std::this_thread::sleep_for(milliseconds(100));
    return spinning;
  }
  static void happen(Core& core, const std::string& event) {
    services::Delivery delivery;
    delivery.key = "t";
    delivery.name = event;
    core.deliver(delivery);
  }
  static std::string with_first(const std::string& first) {
    std::string text = kSpinning;
    return text.replace(text.find("Idle"), 4, first);
  }
  static std::string reason(const Value& info) { return info.find("interruption")->find("reason")->as_string(); }
};

TEST_F(LongSteps, EndAtTheDeadlineAsIfTheirInputHadNotCome) {
  begin_server();
  const auto spinning = core(milliseconds(1000));
  ASSERT_TRUE(spinning->start());
  happen(*spinning, "tick");
  happen(*spinning, "spin");
  const Value info = wait(*spinning, [](const Value& now) {
    const Value* interruption = now.find("interruption");
    return interruption && now.find("step")->as_integer() == 2;
  });
  EXPECT_EQ(info.find("status")->as_string(), "interrupted");
  EXPECT_EQ(reason(info), "deadline");
  EXPECT_EQ(runs->get(spinning->run_id())->steps, 2U) << "the start and the tick";
  EXPECT_EQ(observer.calls().back(), ":halt");
  Expected<Value> resumed = spinning->resume();
  for (; !resumed; resumed = spinning->resume()) std::this_thread::sleep_for(milliseconds(5));
  happen(*spinning, "tick");
  const Value after = wait(*spinning, [](const Value& now) { return now.find("step")->as_integer() == 3; });
  EXPECT_EQ(status(after), "running");
}

TEST_F(LongSteps, CanBeStopped) {
  begin_server();
  const auto spinning = spinning_core();
  const auto begin = Clock::now();
  ASSERT_TRUE(spinning->stop());
  EXPECT_LT(Clock::now() - begin, milliseconds(5000)) << "500 ms, but for sanitizers and busy machines";
  EXPECT_EQ(observer.calls().back(), ":halt");
  wait(*spinning, [](const Value& now) { return now.find("status")->as_string() == "aborted"; });
  const RunId id = spinning->run_id();
  while (!runs->get(id)->is_over()) std::this_thread::sleep_for(milliseconds(5));
  EXPECT_EQ(runs->get(id)->steps, 2U) << "the start and the abort";
}

TEST_F(LongSteps, OfTheStartCanBeStopped) {
  begin_server();
  const auto spinning = core(milliseconds(10'000), "A");
  auto started = std::async(std::launch::async, [&] { return spinning->start(); });
  std::this_thread::sleep_for(milliseconds(100));
  ASSERT_TRUE(spinning->stop());
  wait(*spinning, [](const Value& now) { return now.find("status")->as_string() == "aborted"; });
}

TEST_F(LongSteps, AreDurableWhenTheyAreShown) {
  begin_server();
  const auto spinning = spinning_core();
  Value state = spinning->state().value();
  // The macro step may not have begun yet.
  for (; state.find("core")->find("step")->as_integer() < 2; state = spinning->state().value())
    std::this_thread::sleep_for(milliseconds(5));
  EXPECT_EQ(state.find("core")->find("step")->as_integer(), 2);
  EXPECT_GT(state.find("core")->find("micro")->as_integer(), 0);
  EXPECT_EQ(runs->get(spinning->run_id())->steps, 2U);
  spinning->close();
}

TEST_F(LongSteps, CanBeStoppedWhenSomethingOfThemHasBeenShown) {
  begin_server();
  const auto spinning = core();
  ASSERT_TRUE(spinning->start());
  spinning->watch_derivation(true);
  spinning->watch_state();
  happen(*spinning, "spin");
  std::this_thread::sleep_for(milliseconds(100));
  spinning->watch_state();
  const auto begin = Clock::now();
  ASSERT_TRUE(spinning->stop());
  EXPECT_LT(Clock::now() - begin, milliseconds(5000));
  EXPECT_EQ(observer.calls().back(), ":halt");
  const RunId id = spinning->run_id();
  while (!runs->get(id)->is_over()) std::this_thread::sleep_for(milliseconds(5));
  EXPECT_EQ(runs->get(id)->status, "aborted");
  EXPECT_EQ(runs->get(id)->steps, 2U) << "the start and the macro step in which it ended";
}

TEST_F(LongSteps, OfManyCoresDoNotHoldUpOneThatHasLittleToDo) {
  begin_server();
  std::vector<std::shared_ptr<Core>> spinning;
  for (int i = 0; i < 10; ++i) {
    spinning.push_back(core());
    ASSERT_TRUE(spinning.back()->start());
  }
  const auto good = core();
  ASSERT_TRUE(good->start());
  for (const auto& each : spinning) happen(*each, "spin");
  for (std::int64_t step = 2; step < 22; ++step) {
    const auto begin = Clock::now();
    happen(*good, "tick");
    wait(*good, [&](const Value& now) { return now.find("step")->as_integer() == step; });
    EXPECT_LT(Clock::now() - begin, milliseconds(3000));
  }
  for (const auto& each : spinning) each->close();
}

TEST_F(LongSteps, DoNotKeepAServerThatEnds) {
  begin_server();
  const auto spinning = spinning_core();
  const auto begin = Clock::now();
  spinning->close();
  pool->end();
  EXPECT_LT(Clock::now() - begin, milliseconds(5000));
}

}  // namespace
}  // namespace race::server
