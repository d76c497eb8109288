#include "services/host/motion_gate.h"

#include <gmock/gmock.h>

#include "core/rsm/document.h"
#include "tests/unit/services/host/bench.h"

namespace race::services {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const rsm::Service& crane_model() {
  static const rsm::Service model = rsm::read_service_text(R"json({
    "rsm": 1, "name": "crane",
    "operations": [{"name": "lift", "moves": true, "error": "any"}, {"name": "hurry", "moves": true, "paces": true},
                   {"name": "look"}, {"name": "halt", "safe": true},
                   {"name": "lights_out", "safe": true}],
    "events": [], "states": [{"name": "Here"}], "init": "Here",
    "transitions": [{"id": "lift", "src": "Here", "dst": "Here", "operation": "lift"},
                    {"id": "hurry", "src": "Here", "dst": "Here", "operation": "hurry"},
                    {"id": "look", "src": "Here", "dst": "Here", "operation": "look"},
                    {"id": "halt", "dst": "Here", "operation": "halt"},
                    {"id": "lights_out", "dst": "Here", "operation": "lights_out"}]})json",
                                                           "services/crane")
                                        .value();
  return model;
}

// Answers at once, unless it is told to be silent.
class Crane final : public Component {
 public:
  explicit Crane(ServiceHost& its_host) : host(its_host) {}
  const rsm::Service& model() const override { return crane_model(); }
  void call(const Call& call) override {
    calls.push_back(call.operation);
    host.transition(call.operation, call.id);
    if (!silent) host.result(call.id, nullptr);
  }
  ServiceHost& host;
  std::vector<std::string> calls;
  bool silent = false;
};

// Refuses what it is told to refuse, and keeps what it was asked.
struct Gate final : MotionGate {
  Expected<std::uint64_t> begin(const Beginning&) override { return 1; }
  Expected<void> may_force(const Beginning&) override { return {}; }
  bool confirms_edits(const std::string&) override { return false; }
  std::optional<Value> refuse(const Caller& caller, const std::string& service, rsm::CallEffect effect) override {
    const std::string pace = effect == rsm::CallEffect::pace ? " pace" : "";
    asked.push_back(caller.core + " " + std::to_string(caller.fence) + " " + service + pace);
    return refusal;
  }
  void release(const std::string& core, const std::string& service) override {
    released.push_back(core + " " + service);
  }
  std::optional<Value> refusal;
  std::vector<std::string> asked, released;
};

struct MotionGateTest : testing::Test {
  Gate gate;
  Bench bench{&gate};
  Crane& crane = bench.add<Crane>("crane");
};

TEST_F(MotionGateTest, IsAskedForCallsThatMoveAlone) {
  bench.host.call({"7", 1, 3}, "crane", "lift", {}, {});
  bench.host.call({"7", 2, 3}, "crane", "look", {}, {});
  bench.host.call({"7", 3, 3}, "crane", "hurry", {}, {});
  bench.queue.run();
  EXPECT_THAT(gate.asked, ElementsAre("7 3 crane", "7 3 crane pace"));
  EXPECT_THAT(crane.calls, ElementsAre("lift", "look", "hurry"));
}

TEST_F(MotionGateTest, ARefusedCallIsAnsweredAndReachesNoComponent) {
  gate.refusal = error_value("stopped", "not now");
  bench.call("crane", "lift");
  bench.call("crane", "look");
  EXPECT_THAT(crane.calls, ElementsAre("look"));
  EXPECT_THAT(bench.responses(), ElementsAre("crane.lift !> stopped", "crane.look -> null"));
  EXPECT_THAT(bench.violations("crane"), IsEmpty());
}

TEST_F(MotionGateTest, IsAskedWhereACallArrivesNotWhereItIsMade) {
  bench.host.call({"7", 1, 3}, "crane", "lift", {}, {});
  gate.refusal = error_value("stopped", "meanwhile");
  bench.queue.run();
  EXPECT_THAT(crane.calls, IsEmpty());
}

TEST_F(MotionGateTest, ACoreThatIsOverGivesAllServicesBackAfterItsCalls) {
  bench.host.call({"7", 1, 3}, "crane", "lift", {}, {});
  bench.host.abandon_all("7");
  EXPECT_THAT(gate.released, IsEmpty());
  bench.queue.run();
  EXPECT_THAT(gate.asked, ElementsAre("7 3 crane"));
  EXPECT_THAT(gate.released, ElementsAre("7 crane"));
}

TEST_F(MotionGateTest, ALostServiceIsGivenBackToo) {
  bench.host.disconnect("crane");
  bench.host.abandon_all("7");
  bench.queue.run();
  EXPECT_THAT(gate.released, ElementsAre("7 crane"));
}

TEST_F(MotionGateTest, SafeOperationsComeBeforeAllThatWaitHoweverMuchThatIs) {
  crane.silent = true;
  for (std::uint64_t call = 1; call <= CallLedger::kMostPending; ++call) bench.call("crane", "look");
  ASSERT_EQ(bench.host.service("crane")->pending_count, CallLedger::kMostPending) << "no call has room any more";
  for (std::uint64_t call = 1; call <= 2 * CallLedger::kMostPending; ++call)
    bench.host.call({"8", call, 3}, "crane", "look", {}, {});
  crane.calls.clear();
  bench.host.call_safe();
  bench.queue.run_for(std::chrono::microseconds(1));
  bench.queue.run_for(std::chrono::microseconds(1));
  bench.queue.run();
  EXPECT_THAT(crane.calls, ElementsAre("halt", "lights_out"));
}

}  // namespace
}  // namespace race::services
