// Inputs of a core that wait: of one that is paused, and more than may wait.
#include <gtest/gtest.h>

#include <string>

#include "core/rcm/document.h"
#include "core/rsm/document.h"
#include "server/execution/cores.h"
#include "tests/unit/server/hosted_cores.h"

namespace race::server {
namespace {

struct WaitingInputsOfCores : HostedCores {
  // Counts what happens, and takes the newest of what is sampled.
  std::shared_ptr<Core> counting_core() {
    static constexpr const char* kDocument = R"({"rcm": 1, "name": "count", "root": {"state": "Root",
        "variables": [{"name": "n", "initial": 0}],
        "actions": [{"when": "svc.t.alarm", "do": "var.n = var.n + 1"}, {"when": "svc.t.pose", "do": "pass"}]}})";
    static constexpr const char* kService = R"({"operations": [],
        "events": [{"name": "alarm"}, {"name": "pose", "sampled": true}, {"name": "unread"}]})";
    const auto header = execution::journal_of(rcm::read_document_text(kDocument).value(),
                                              {{"t", rsm::read_service_text(kService, "t").value()}})
                            .header;
    RunRecord run = runs->create({"count", 1, header, {}}, 0).value();
    return Core::create(std::move(run), header, {*pool, host, *this, *runs, *writer, replays, deadlines, watchdog})
        .value();
  }
  static void happen(Core& core, const std::string& event, std::size_t times, const Value& data = 1) {
    services::Delivery delivery;
    delivery.key = "t";
    delivery.name = event;
    delivery.data = data;
    delivery.data.freeze();
    delivery.units = delivery.data.size_units();
    for (std::size_t i = 0; i < times; ++i) core.deliver(delivery);
  }
  static std::int64_t waiting(const Value& info) { return info.find("waiting")->as_integer(); }
  static std::string reason(const Value& info) { return info.find("interruption")->find("reason")->as_string(); }
  static bool is_interrupted(const Value& info) { return info.find("status")->as_string() == "interrupted"; }
  // What has been delivered has reached the run; it is rebuilt, if it was interrupted.
  static Value settled(Core& core) {
    auto state = core.state();
    while (!state) state = core.state();
    return *state->find("core");
  }
};

TEST_F(WaitingInputsOfCores, OfAPausedCoreAreCounted) {
  begin_server();
  const auto core = counting_core();
  ASSERT_TRUE(core->start());
  ASSERT_TRUE(core->pause());
  happen(*core, "alarm", 70);
  happen(*core, "pose", 70);
  happen(*core, "unread", 70);
  std::ignore = settled(*core);
  EXPECT_EQ(waiting(core->info()), 71) << "of what is sampled the newest, of what nobody reads nothing";
  ASSERT_TRUE(core->resume());
  wait(*core, [](const Value& info) { return info.find("step")->as_integer() == 72; });
  EXPECT_EQ(waiting(core->info()), 0);
}

TEST_F(WaitingInputsOfCores, AsManyAsMayWaitAreTaken) {
  begin_server();
  const auto core = counting_core();
  ASSERT_TRUE(core->start());
  ASSERT_TRUE(core->pause());
  happen(*core, "alarm", Core::kMostInputs);
  EXPECT_EQ(waiting(settled(*core)), static_cast<std::int64_t>(Core::kMostInputs));
  ASSERT_TRUE(core->resume());
  wait(*core, [](const Value& info) { return info.find("step")->as_integer() == Core::kMostInputs + 1; });
}

TEST_F(WaitingInputsOfCores, BeyondThatTheRunIsInterruptedAndGoesOnWithWhatComesLater) {
  begin_server();
  const auto core = counting_core();
  ASSERT_TRUE(core->start());
  ASSERT_TRUE(core->pause());
  happen(*core, "alarm", Core::kMostInputs + 1);
  Value info = wait(*core, is_interrupted);
  EXPECT_EQ(reason(info), "overload");
  settled(*core);
  happen(*core, "alarm", 3 * Core::kMostInputs);
  info = settled(*core);
  EXPECT_TRUE(is_interrupted(info));
  EXPECT_EQ(waiting(info), static_cast<std::int64_t>(Core::kMostInputs)) << "the rest is dropped";
  while (!core->resume()) std::this_thread::yield();
  wait(*core, [](const Value& now) { return now.find("step")->as_integer() == Core::kMostInputs + 1; });
  EXPECT_EQ(status(core->stop()), "aborted");
}

TEST_F(WaitingInputsOfCores, OfLargeDataFewerMayWait) {
  begin_server();
  const auto core = counting_core();
  ASSERT_TRUE(core->start());
  ASSERT_TRUE(core->pause());
  const Value large = std::string(Core::kMostInputUnits / 8, 'x');
  happen(*core, "alarm", 8, large);
  EXPECT_EQ(waiting(settled(*core)), 8);
  EXPECT_FALSE(is_interrupted(core->info()));
  for (int i = 0; i < 20; ++i) {  // what is taken makes room
    ASSERT_TRUE(core->step({execution::Goal::Kind::macro}));
    happen(*core, "alarm", 1, large);
    EXPECT_EQ(waiting(settled(*core)), 8) << i;
  }
  happen(*core, "alarm", 2, large);
  EXPECT_EQ(reason(wait(*core, is_interrupted)), "overload");
}

}  // namespace
}  // namespace race::server
