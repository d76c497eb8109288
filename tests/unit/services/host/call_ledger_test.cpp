// The calls of one service that wait for a response, and what does not fit its RSM.
#include "services/host/call_ledger.h"

#include <gmock/gmock.h>

#include "core/rsm/document.h"

namespace race::services {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const rsm::Service& blinking_lamp() {
  static const rsm::Service model = rsm::read_service_text(R"json({
    "rsm": 1, "name": "lamp", "operations": [{"name": "on"}, {"name": "blink"}], "events": [{"name": "lit"}],
    "states": [{"name": "Dark"}, {"name": "Bright"}], "init": "Dark",
    "transitions": [{"id": "on", "src": "Dark", "dst": "Bright", "operation": "on"},
                    {"id": "blink", "src": "Bright", "dst": "Bright", "operation": "blink", "defer": ["off"]},
                    {"id": "off", "src": "Bright", "dst": "Dark"}]})json",
                                                           "lamp")
                                        .value();
  return model;
}

struct CallLedgerTest : testing::Test {
  void call(CallId id, const std::string& operation) { ledger.call({id, operation, 1.0, {"core", id}}, {}, {}); }
  std::vector<CallId> pending() const {
    std::vector<CallId> ids;
    for (const auto& [id, call] : ledger.pending()) ids.push_back(id);
    return ids;
  }
  void accept(CallId id, const std::string& operation) {
    call(id, operation);
    ledger.transition(1.0, operation, id);
  }
  /// Call 1 has been answered, and 3 has superseded 2, as `blink` is deferred (R17).
  void answer_one_and_supersede_two() {
    accept(1, "on");
    ledger.respond(1.0, 1, nullptr, false);
    ledger.take(1);
    accept(2, "blink");
    accept(3, "blink");
  }
  CallLedger ledger{blinking_lamp()};
};

TEST_F(CallLedgerTest, ACallIsTakenOnceWithItsCaller) {
  call(7, "on");
  const auto taken = ledger.take(7);
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->operation, "on");
  EXPECT_EQ(taken->caller, (Caller{"core", 7}));
  EXPECT_FALSE(ledger.take(7));
}

TEST_F(CallLedgerTest, FollowsTheStateOfTheService) {
  EXPECT_EQ(ledger.state(), "Dark");
  call(1, "on");
  EXPECT_THAT(ledger.transition(2.0, "on", 1), IsEmpty());
  EXPECT_EQ(ledger.state(), "Bright");
}

TEST_F(CallLedgerTest, ALaterCallSupersedesAnEarlierOneThatIsDeferred) {
  answer_one_and_supersede_two();
  EXPECT_THAT(pending(), ElementsAre(3));
}

TEST_F(CallLedgerTest, AViolationHasItsTimeItsCallAndItsOperation) {
  call(4, "on");
  const auto found = ledger.transition(2.5, "blink", 4);
  ASSERT_THAT(found, SizeIs(testing::Ge(1U)));
  EXPECT_EQ(found[0].time, 2.5);
  EXPECT_EQ(found[0].call, 4U);
  EXPECT_EQ(found[0].operation, "on");
  EXPECT_THAT(ledger.violations(), SizeIs(found.size()));
}

TEST_F(CallLedgerTest, KeepsTheLastViolations) {
  for (std::size_t i = 0; i < CallLedger::kViolationsKept + 5; ++i)
    ledger.add(static_cast<Time>(i), {{"rule", "message", 0}});
  ASSERT_THAT(ledger.violations(), SizeIs(CallLedger::kViolationsKept));
  EXPECT_EQ(ledger.violations().front().time, 5.0);
}

TEST_F(CallLedgerTest, AResetReturnsWhatWasPendingInOrderAndStartsAnew) {
  call(1, "on");
  ledger.transition(1.0, "on", 1);
  call(2, "blink");
  const auto left = ledger.reset();
  ASSERT_THAT(left, SizeIs(2));
  EXPECT_TRUE(left.contains(1));
  EXPECT_TRUE(left.contains(2));
  EXPECT_THAT(pending(), IsEmpty());
  EXPECT_EQ(ledger.state(), "Dark");
}

TEST_F(CallLedgerTest, IsFullOfSoManyCalls) {
  for (CallId id = 1; id <= CallLedger::kMostPending; ++id) {
    ASSERT_FALSE(ledger.is_full()) << id;
    call(id, "on");
  }
  EXPECT_TRUE(ledger.is_full());
  ledger.take(5);
  EXPECT_FALSE(ledger.is_full());
}

TEST_F(CallLedgerTest, IsFullOfSoManyArgumentsUntilTheirCallsAreOver) {
  accept(1, "on");
  ledger.take(1);
  for (const CallId id : {2, 3, 4, 5})
    ledger.call({id, "blink", 1.0, {"core", id}, CallLedger::kMostPendingUnits / 4}, {}, {});
  EXPECT_FALSE(ledger.is_full()) << "as many as may";
  call(6, "blink");
  EXPECT_FALSE(ledger.is_full());
  ledger.call({7, "blink", 1.0, {"core", 7}, 1}, {}, {});
  EXPECT_TRUE(ledger.is_full());
  for (const CallId id : {2, 3}) ledger.transition(1.0, "blink", id);
  EXPECT_FALSE(ledger.is_full()) << "3 has superseded 2 (R17)";
  ledger.call({8, "blink", 1.0, {"core", 8}, CallLedger::kMostPendingUnits}, {}, {});
  EXPECT_TRUE(ledger.is_full());
  ledger.reset();
  EXPECT_FALSE(ledger.is_full());
}

TEST_F(CallLedgerTest, AbandonsACallOnceAndKeepsItPending) {
  call(1, "on");
  EXPECT_EQ(ledger.abandon({"other", 1}), 0U);
  EXPECT_EQ(ledger.abandon({"core", 1}), 1U);
  EXPECT_EQ(ledger.abandon({"core", 1}), 0U);
  EXPECT_THAT(pending(), ElementsAre(1)) << "it must still be answered";
  EXPECT_TRUE(ledger.take(1));
}

TEST_F(CallLedgerTest, AbandonsNoCallThatIsPendingNoLonger) {
  answer_one_and_supersede_two();
  EXPECT_EQ(ledger.abandon({"core", 1}), 0U) << "answered";
  EXPECT_EQ(ledger.abandon({"core", 2}), 0U) << "superseded (R17)";
  ledger.reset();
  EXPECT_EQ(ledger.abandon({"core", 3}), 0U) << "lost";
}

TEST_F(CallLedgerTest, AbandonsAllCallsOfACore) {
  for (const CallId id : {1, 2, 3}) call(id, "on");
  ledger.call({4, "on", 1.0, {"core2", 1}}, {}, {});
  ledger.call({5, "on", 1.0, {}}, {}, {});
  ledger.abandon({"core", 2});
  EXPECT_THAT(ledger.abandon_all("core"), ElementsAre(1, 3));
  EXPECT_THAT(ledger.abandon_all("core"), IsEmpty());
  EXPECT_THAT(ledger.abandon_all("core2"), ElementsAre(4));
  EXPECT_THAT(ledger.abandon_all(""), IsEmpty()) << "the server waits for nothing";
}

}  // namespace
}  // namespace race::services
