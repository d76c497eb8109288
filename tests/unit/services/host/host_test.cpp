#include <gmock/gmock.h>

#include <chrono>
#include <future>

#include "core/rsm/document.h"
#include "tests/unit/services/host/bench.h"

namespace race::services {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const rsm::Service& lamp_model() {
  static const rsm::Service model = rsm::read_service_text(R"json({
    "rsm": 1, "name": "lamp",
    "operations": [{"name": "on"}, {"name": "blink", "error": "any"}],
    "events": [{"name": "lit"}, {"name": "spark", "sampled": true}],
    "states": [{"name": "Dark"}, {"name": "Bright", "events": ["spark"]}], "init": "Dark",
    "transitions": [{"id": "t1", "src": "Dark", "dst": "Bright", "operation": "on", "events": ["lit"]},
                    {"id": "t2", "src": "Bright", "dst": "Bright", "operation": "blink", "defer": ["t3"]},
                    {"id": "t3", "src": "Bright", "dst": "Dark"}]})json",
                                                           "services/lamp")
                                        .value();
  return model;
}

// A lamp that does what a test tells it.
class Lamp final : public Component {
 public:
  explicit Lamp(ServiceHost& its_host) : host(its_host) {}
  const rsm::Service& model() const override { return lamp_model(); }
  void call(const Call& call) override {
    calls.push_back(call);
    if (answer) answer(call);
  }
  void limit_speed(std::optional<double> tool_speed) override { limits.push_back({tool_speed, calls.size(), steps}); }
  void abandoned(CallId call) override { abandoned_calls.push_back(call); }
  void step() override {
    if (broken) throw std::runtime_error("burnt out");
    ++steps;
  }
  struct Limit {
    std::optional<double> tool_speed;
    std::size_t calls;  // that had come before it
    int steps;
    bool operator==(const Limit&) const = default;
  };
  ServiceHost& host;
  std::vector<Call> calls;
  std::vector<CallId> abandoned_calls;
  std::vector<Limit> limits;
  int steps = 0;
  std::function<void(const Call&)> answer;
  bool broken = false;
};

struct HostTest : testing::Test {
  HostTest() : lamp(bench.add<Lamp>("lamp")) {}
  void obey() {
    lamp.answer = [this](const Call& call) {
      lamp.host.transition(call.operation == "on" ? "t1" : "t2", call.id);
      if (call.operation != "on") return;
      lamp.host.result(call.id, nullptr);
      lamp.host.event("lit", nullptr);
    };
  }
  Bench bench;
  Lamp& lamp;
};

TEST_F(HostTest, AComponentIsCalledOnItsQueueOnly) {
  bench.host.call({"1", 1}, "lamp", "on", {}, {});
  EXPECT_THAT(lamp.calls, IsEmpty());
  bench.queue.run();
  EXPECT_EQ(lamp.calls.size(), 1U);
}

TEST_F(HostTest, AResponseGoesToTheCallerWithItsNumberOfTheCall) {
  obey();
  bench.host.call({"7", 42}, "lamp", "on", {}, {});
  bench.queue.run();
  ASSERT_THAT(bench.responses(), ElementsAre("lamp.on -> null"));
  EXPECT_EQ(bench.deliveries[0].caller, (Caller{"7", 42}));
  EXPECT_THAT(bench.violations("lamp"), IsEmpty());
}

TEST_F(HostTest, PendingCallsAreSeenUntilTheyAreAnswered) {
  obey();
  bench.call("lamp", "on");
  const CallId id = bench.call("lamp", "blink");
  ASSERT_EQ(bench.host.service("lamp")->pending.size(), 1U);
  EXPECT_EQ(bench.host.service("lamp")->pending[0].id, id);
  lamp.host.transition("t3");
  lamp.host.result(id, 3);
  EXPECT_THAT(bench.host.service("lamp")->pending, IsEmpty());
  EXPECT_EQ(bench.host.service("lamp")->state, "Dark");
  EXPECT_EQ(bench.host.service("lamp")->last, "t3");
  EXPECT_THAT(bench.violations("lamp"), IsEmpty());
}

TEST_F(HostTest, AnUnknownServiceOrOperationAnswersUnavailable) {
  bench.call("heater", "on");
  bench.call("lamp", "explode");
  EXPECT_THAT(bench.responses(), ElementsAre("heater.on !> unavailable", "lamp.explode !> unavailable"));
  EXPECT_THAT(lamp.calls, IsEmpty());
}

TEST_F(HostTest, ARejectedCallAnswersNotAcceptedAndNothingElse) {
  lamp.answer = [this](const Call& call) { lamp.host.reject(call.id); };
  bench.call("lamp", "blink");
  ASSERT_THAT(bench.responses(), ElementsAre("lamp.blink !> not_accepted"));
  EXPECT_EQ(bench.deliveries[0].data, Value(Dict{{"code", "not_accepted"}}));
  EXPECT_THAT(bench.violations("lamp"), IsEmpty());
}

TEST_F(HostTest, WhatDoesNotFitTheRsmIsDeliveredAndShownWithRuleAndCall) {
  lamp.answer = [this](const Call& call) { lamp.host.result(call.id, 5); };  // no transition took the call
  const CallId id = bench.call("lamp", "on");
  EXPECT_THAT(bench.responses(), ElementsAre("lamp.on -> 5"));
  const auto violations = bench.violations("lamp");
  ASSERT_EQ(violations.size(), 1U);
  EXPECT_EQ(violations[0].rule, "respond");
  EXPECT_EQ(violations[0].call, id);
  EXPECT_EQ(violations[0].operation, "on");
  EXPECT_THAT(bench.log, ElementsAre(HasSubstr("respond")));
}

TEST_F(HostTest, ATransitionFromTheWrongStateBreaksTrans2) {
  lamp.host.transition("t3");
  ASSERT_EQ(bench.violations("lamp").size(), 1U);
  EXPECT_EQ(bench.violations("lamp")[0].rule, "Trans2");
}

TEST_F(HostTest, ACallIsAnsweredOnce) {
  obey();
  const CallId id = bench.call("lamp", "on");
  lamp.host.result(id, 1);
  EXPECT_THAT(bench.responses(), ElementsAre("lamp.on -> null"));
  EXPECT_EQ(bench.violations("lamp").size(), 1U);
}

TEST_F(HostTest, OfACallThatALaterOneSupersedesNothingWaits) {
  obey();
  bench.call("lamp", "on");
  bench.call("lamp", "blink");
  const CallId second = bench.call("lamp", "blink");
  ASSERT_EQ(bench.host.service("lamp")->pending.size(), 1U);
  EXPECT_EQ(bench.host.service("lamp")->pending[0].id, second);
}

TEST_F(HostTest, WhatIsLostCanComeBackInItsInitialState) {
  obey();
  bench.call("lamp", "on");
  bench.host.disconnect("lamp", "burnt out");
  bench.call("lamp", "blink");
  EXPECT_THAT(bench.responses(), ElementsAre("lamp.on -> null", "lamp.blink !> unavailable"));
  bench.host.reconnect("lamp");
  EXPECT_TRUE(bench.host.service("lamp")->available);
  EXPECT_EQ(bench.host.service("lamp")->state, "Dark");
  EXPECT_EQ(bench.host.service("lamp")->last, "");
  bench.call("lamp", "on");
  EXPECT_EQ(bench.responses().back(), "lamp.on -> null");
  EXPECT_THAT(bench.violations("lamp"), IsEmpty());
  EXPECT_THAT(bench.log, testing::IsSupersetOf({"lost: burnt out", "available"}));
}

TEST_F(HostTest, WhatWasMeantForTheLostDoesNotReachItsSuccessor) {
  bench.host.call({"1", 1}, "lamp", "on", {}, {});
  bench.host.disconnect("lamp");
  bench.host.reconnect("lamp");
  bench.queue.run();
  EXPECT_THAT(lamp.calls, IsEmpty());
  EXPECT_THAT(bench.responses(), ElementsAre("lamp.on !> unavailable"));
}

TEST_F(HostTest, AnAbandonedCallIsToldToItsComponentOnce) {
  const CallId first = bench.call("lamp", "blink"), second = bench.call("lamp", "blink");
  bench.host.abandon({"1", 1});
  bench.host.abandon({"1", 1});
  EXPECT_THAT(lamp.abandoned_calls, IsEmpty()) << "not on its queue";
  bench.queue.run();
  EXPECT_THAT(lamp.abandoned_calls, ElementsAre(first));
  EXPECT_EQ(bench.host.service("lamp")->pending.size(), 2U) << "it is still answered";
  bench.host.abandon_all("2");
  bench.host.abandon_all("1");
  bench.queue.run();
  EXPECT_THAT(lamp.abandoned_calls, ElementsAre(first, second));
  EXPECT_THAT(bench.responses(), IsEmpty());
}

TEST_F(HostTest, OnlyAnOpenCallIsAbandoned) {
  obey();
  auto& other = bench.add<Lamp>("other");
  const CallId on = bench.call("lamp", "on");
  bench.host.abandon({"1", 1});
  bench.host.abandon({"1", 99});
  const CallId blink = bench.call("lamp", "blink");
  bench.host.abandon({"1", 2});
  lamp.host.result(blink, 3);  // before it has heard of it
  bench.call("other", "on");
  bench.host.abandon({"1", 3});
  bench.host.disconnect("other");
  bench.host.reconnect("other");
  bench.queue.run();
  EXPECT_THAT(lamp.abandoned_calls, IsEmpty()) << on << " and " << blink << " were answered";
  EXPECT_THAT(other.abandoned_calls, IsEmpty()) << "its successor has not been called";
}

TEST_F(HostTest, ACallThatIsAbandonedBeforeItArrivesArrivesFirst) {
  const CallId call = bench.host.call({"1", 1}, "lamp", "on", {}, {});
  bench.host.abandon_all("1");
  bench.queue.run();
  EXPECT_EQ(lamp.calls.size(), 1U);
  EXPECT_THAT(lamp.abandoned_calls, ElementsAre(call));
}

TEST_F(HostTest, OnlySoManyViolationsAreKept) {
  for (int i = 0; i < 150; ++i) lamp.host.event("unheard_of", i);
  EXPECT_EQ(bench.violations("lamp").size(), CallLedger::kViolationsKept);
}

TEST_F(HostTest, ALostServiceAnswersItsPendingCallsInOrderAndFallsSilent) {
  bench.call("lamp", "blink");
  bench.call("lamp", "on");
  bench.host.disconnect("lamp");
  EXPECT_THAT(bench.responses(), ElementsAre("lamp.blink !> unavailable", "lamp.on !> unavailable"));
  const auto before = bench.deliveries.size();
  lamp.host.event("spark", nullptr);
  EXPECT_EQ(bench.deliveries.size(), before);
  bench.call("lamp", "on");
  EXPECT_EQ(bench.responses().back(), "lamp.on !> unavailable");
  EXPECT_FALSE(bench.host.service("lamp")->available);
}

TEST_F(HostTest, AComponentThatThrowsIsLostAndTheOthersGoOn) {
  auto& other = bench.add<Lamp>("other");
  bench.call("lamp", "on");
  lamp.broken = true;
  bench.pass(0.002);
  EXPECT_THAT(bench.responses(), ElementsAre("lamp.on !> unavailable"));
  bench.call("other", "on");
  EXPECT_EQ(other.calls.size(), 1U);
}

TEST_F(HostTest, OfManyPendingCallsTheFirstAreShownAndAllAreCounted) {
  constexpr std::size_t kShown = ServiceStatus::kPendingShown;
  for (std::size_t i = 0; i <= kShown; ++i) bench.call("lamp", "blink");
  const auto status = bench.host.service("lamp");
  EXPECT_EQ(status->pending_count, kShown + 1);
  ASSERT_EQ(status->pending.size(), kShown);
  EXPECT_EQ(status->pending.front().id, lamp.calls.front().id);
  lamp.host.reject(lamp.calls.front().id);
  EXPECT_EQ(bench.host.service("lamp")->pending.back().id, lamp.calls.back().id);
}

TEST_F(HostTest, AServiceForWhichTooManyCallsWaitAnswersUnavailableAndSaysSoOnce) {
  constexpr std::size_t kMost = CallLedger::kMostPending;
  const auto call_often = [&](std::size_t times) {
    for (std::size_t i = 0; i < times; ++i) bench.host.call({"1", ++bench.calls}, "lamp", "blink", {}, {});
    bench.queue.run();
  };
  call_often(kMost + 3);
  EXPECT_EQ(lamp.calls.size(), kMost);
  EXPECT_EQ(bench.responses(), std::vector<std::string>(3, "lamp.blink !> unavailable"));
  EXPECT_THAT(bench.log, ElementsAre(HasSubstr("as many calls wait already as may")));
  lamp.host.reject(lamp.calls[0].id);
  call_often(2);
  EXPECT_EQ(lamp.calls.size(), kMost + 1) << "one has had its answer";
  EXPECT_EQ(bench.log.size(), 1U) << "it is full as before";
  for (std::size_t i = 1; i <= kMost / 2; ++i) lamp.host.reject(lamp.calls[i].id);
  call_often(1);
  call_often(kMost / 2);
  EXPECT_EQ(bench.log.size(), 2U) << "it is full again";
}

TEST_F(HostTest, WhoCallsWaitsForNoObserver) {
  bool called = false;
  std::future<CallId> call;  // whose end waits for the observer, if it does
  bench.on_log = [&] {
    call = std::async(std::launch::async, [&] { return bench.host.call({"2", 1}, "lamp", "blink", {}, {}); });
    called = call.wait_for(std::chrono::seconds(5)) == std::future_status::ready;
    bench.on_log = nullptr;
  };
  lamp.host.log("an observer is busy with this");
  EXPECT_TRUE(called);
  bench.queue.run();
  EXPECT_EQ(lamp.calls.size(), 1U);
}

TEST_F(HostTest, WhatIsOnItsWayWhenItsServiceIsLostIsAnsweredAndDoesNotReachItLater) {
  bench.host.call({"1", 1}, "lamp", "on", {}, {});
  bench.host.disconnect("lamp");
  bench.host.reconnect("lamp");
  bench.queue.run();
  EXPECT_THAT(bench.responses(), ElementsAre("lamp.on !> unavailable"));
  EXPECT_THAT(lamp.calls, IsEmpty());
}

TEST_F(HostTest, ServicesAreFullEachForItself) {
  auto& other = bench.add<Lamp>("other");
  for (std::size_t i = 0; i <= CallLedger::kMostPending; ++i)
    bench.host.call({"1", ++bench.calls}, "lamp", "on", {}, {});
  bench.call("other", "on");
  EXPECT_EQ(other.calls.size(), 1U);
}

TEST_F(HostTest, ObserversAreToldOfTheFirstAndTheLastStateOfMany) {
  bench.pass(0.1);
  bench.changes.clear();
  obey();
  bench.call("lamp", "on");
  for (int i = 0; i < 100; ++i) bench.call("lamp", "blink");
  EXPECT_THAT(bench.changes, IsEmpty()) << "not before time passes";
  bench.pass(0.001);
  EXPECT_THAT(bench.changes, ElementsAre("lamp: Bright by t2, 1 pending"));
  lamp.host.transition("t3");
  bench.pass(0.010);
  bench.call("lamp", "on");
  bench.pass(0.005);
  EXPECT_EQ(bench.changes.size(), 1U) << "again after kStatusPeriod";
  bench.pass(0.010);
  EXPECT_THAT(bench.changes, ElementsAre("lamp: Bright by t2, 1 pending", "lamp: Bright by t1, 1 pending"));
  bench.pass(1);
  EXPECT_EQ(bench.changes.size(), 2U) << "nothing changes any more";
}

TEST_F(HostTest, AResponseAndAnEventAreCountedOnceForAllCores) {
  lamp.answer = [this](const Call& call) { lamp.host.result(call.id, List{1, "two", List{}}); };
  bench.call("lamp", "on");
  lamp.host.event("lit", "bright");
  ASSERT_EQ(bench.deliveries.size(), 2U);
  for (const Delivery& each : bench.deliveries) EXPECT_EQ(each.units, each.data.size_units());
  EXPECT_EQ(bench.deliveries[0].units, 1U + 1U + 4U + 1U);
  EXPECT_EQ(bench.deliveries[1].units, 7U);
}

TEST(Delivery, ReachesCoresByTimeThenServiceThenSequence) {
  Delivery early, late, second;
  late.time = 1;
  second.service = 1;
  second.sequence = 0;
  early.sequence = 5;
  EXPECT_TRUE(before(early, late));
  EXPECT_TRUE(before(early, second));
  EXPECT_FALSE(before(second, early));
  EXPECT_TRUE(before(second, late));
}

// ---- The limit of the speed.

using Limit = Lamp::Limit;

TEST_F(HostTest, AComponentIsToldOfALimitOfTheSpeedOnItsQueueBeforeWhatWaits) {
  for (int i = 0; i < 3; ++i) bench.host.call({"1", ++bench.calls}, "lamp", "on", {}, {});
  bench.host.limit_speed(0.25);
  EXPECT_THAT(lamp.limits, IsEmpty()) << "on its queue only";
  bench.queue.run();
  EXPECT_EQ(lamp.calls.size(), 3U);
  EXPECT_THAT(lamp.limits, ElementsAre(Limit{0.25, 0, 0}));
}

TEST_F(HostTest, ALimitOfTheSpeedComesBeforeWhatWaitsInRealTimeToo) {
  bench.host.call_safe();
  for (int i = 0; i < 3; ++i) bench.host.call({}, "lamp", "on", {}, {});
  bench.host.limit_speed(0.25);
  bench.queue.run_for(std::chrono::seconds(1));
  EXPECT_THAT(lamp.limits, ElementsAre(Limit{0.25, 0, 0}));
}

TEST_F(HostTest, LimitsOfTheSpeedAreToldInOrderAndTheNewestHolds) {
  bench.host.limit_speed(0.25);
  bench.queue.run();
  bench.host.limit_speed({});
  bench.queue.run();
  bench.host.limit_speed({});
  bench.host.limit_speed(0.1);
  bench.queue.run();
  bench.queue.run();
  EXPECT_THAT(lamp.limits, ElementsAre(Limit{0.25, 0, 0}, Limit{std::nullopt, 0, 0}, Limit{0.1, 0, 0}));
}

TEST_F(HostTest, WhatIsNeverLimitedIsToldOfNoLimit) {
  bench.host.disconnect("lamp");
  bench.host.reconnect("lamp");
  bench.call("lamp", "on");
  EXPECT_THAT(lamp.limits, IsEmpty());
}

TEST_F(HostTest, WhatReconnectsIsToldOfTheLimitOfTheSpeedBeforeAnythingElse) {
  bench.host.disconnect("lamp");
  bench.host.limit_speed(0.25);
  bench.host.call({"1", 1}, "lamp", "on", {}, {});  // on its way while nobody is there
  bench.host.reconnect("lamp");
  bench.host.step(bench.queue);
  bench.queue.run();
  EXPECT_EQ(lamp.calls.size(), 1U);
  EXPECT_THAT(lamp.limits, ElementsAre(Limit{0.25, 0, 0}));
  bench.host.disconnect("lamp");
  bench.host.reconnect("lamp");
  bench.queue.run();
  EXPECT_THAT(lamp.limits, ElementsAre(Limit{0.25, 0, 0}, Limit{0.25, 1, 1})) << "it may have begun anew";
}

TEST_F(HostTest, WhatWasLostWithALimitOfTheSpeedLearnsThatThereIsNoneAnyMore) {
  bench.host.limit_speed(0.25);
  bench.queue.run();
  bench.host.disconnect("lamp");
  bench.host.limit_speed({});
  bench.host.reconnect("lamp");
  bench.queue.run();
  EXPECT_THAT(lamp.limits, ElementsAre(Limit{0.25, 0, 0}, Limit{std::nullopt, 0, 0}));
}

TEST_F(HostTest, WhatIsAttachedOrReplacedLaterIsToldOfTheLimitOfTheSpeed) {
  bench.host.limit_speed(0.25);
  auto& torch = bench.add<Lamp>("torch");
  bench.host.step(bench.queue);
  EXPECT_THAT(torch.limits, ElementsAre(Limit{0.25, 0, 0}));
  auto another = std::make_unique<Lamp>(lamp.host);
  const Lamp& made = *another;
  bench.host.replace("lamp", std::move(another), "a new one");
  bench.call("lamp", "on");
  EXPECT_THAT(made.limits, ElementsAre(Limit{0.25, 0, 0}));
}

}  // namespace
}  // namespace race::services
