// The order of ports, actions and children as a policy of a step: what is an order, and where each rule follows it.
// order_random_test.cpp holds it on random models.
#include "core/semantics/order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/core/semantics/small_runs.h"

namespace race::semantics {
namespace {

using testing::ElementsAre;

std::vector<std::string> event(SmallRun& run, std::string_view name, const Order& order) {
  run->post_event("t", name, Dict{{"x", Value(0)}});
  return run.step(order);
}

// 5 ports, 3 actions and 4 children, of which the third is a barrier.
const char* const kLists = R"({'state': 'R', 'ports': [
    {'name': 'p0', 'when': 'var.n > 9'}, {'name': 'p1', 'when': 'var.n > 9'}, {'name': 'p2', 'when': 'var.n > 9'},
    {'name': 'p3', 'when': 'var.n > 9'}, {'name': 'p4', 'when': 'var.n > 9'}],
  'actions': [{'when': 'True', 'do': 'var.n = 0'}, {'when': 'True', 'do': 'var.n = 1'}, {'when': 'True', 'do': 'var.n = 2'}],
  'children': [{'state': 'A'}, {'state': 'B'}, {'barrier': 'c', 'to': ['A']}, {'state': 'D'}]})";

// The declared positions of the elements of the root, in the order.
struct OrderPositions {
  std::vector<std::uint32_t> ports, actions;
  std::vector<std::string> children;
};
OrderPositions of_root(const Program& program, const Order& order) {
  OrderPositions positions;
  for (const PortId p : order.ports(program, Program::root)) positions.ports.push_back(index(p));
  for (const ActionId a : order.actions(program, Program::root)) positions.actions.push_back(a);
  for (const NodeRef c : order.children(program, Program::root))
    positions.children.push_back(c.barrier ? program[c.as_barrier()].name : program[c.state()].name);
  return positions;
}

TEST(Order, DeclaredIsThatOfTheModel) {
  SmallRun run(kLists);
  const OrderPositions positions = of_root(run->program(), Order::declared());
  EXPECT_THAT(positions.ports, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(positions.actions, ElementsAre(0, 1, 2));
  EXPECT_THAT(positions.children, ElementsAre("A", "B", "c", "D"));
}

TEST(Order, ReversedTakesEveryListFromItsEnd) {
  SmallRun run(kLists);
  const OrderPositions positions = of_root(run->program(), Order::reversed(run->program()));
  EXPECT_THAT(positions.ports, ElementsAre(4, 3, 2, 1, 0));
  EXPECT_THAT(positions.actions, ElementsAre(2, 1, 0));
  EXPECT_THAT(positions.children, ElementsAre("D", "c", "B", "A"));
}

TEST(Order, RandomIsTheSameForASeedOnEveryPlatform) {
  SmallRun run(kLists);
  const OrderPositions one = of_root(run->program(), Order::random(run->program(), 1));
  EXPECT_THAT(one.ports, ElementsAre(2, 1, 4, 3, 0));
  EXPECT_THAT(one.actions, ElementsAre(1, 2, 0));
  EXPECT_THAT(one.children, ElementsAre("D", "c", "A", "B"));
  EXPECT_THAT(of_root(run->program(), Order::random(run->program(), 2)).ports, ElementsAre(1, 3, 4, 2, 0));
}

TEST(Order, OfGivenPermutationsLeavesTheOtherListsDeclared) {
  SmallRun run(kLists);
  const auto order = Order::of(run->program(), {{Program::root, {}, {2, 0, 1}, {3, 2, 0, 1}}});
  ASSERT_TRUE(order);
  const OrderPositions positions = of_root(run->program(), *order);
  EXPECT_THAT(positions.ports, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(positions.actions, ElementsAre(2, 0, 1));
  EXPECT_THAT(positions.children, ElementsAre("D", "c", "A", "B"));
}

TEST(Order, RefusesWhatIsNoPermutation) {
  SmallRun run(kLists);
  const auto refusal = [&](const std::vector<Order::OfState>& states) {
    const auto order = Order::of(run->program(), states);
    return order ? "taken" : to_string(order.error());
  };
  const std::string text = "R: out_of_range: an order must name each position of its list once, from 0";
  EXPECT_EQ(refusal({{Program::root, {0, 1, 2, 3}, {}, {}}}), text) << "one is missing";
  EXPECT_EQ(refusal({{Program::root, {}, {0, 1, 1}, {}}}), text) << "one stands twice";
  EXPECT_EQ(refusal({{Program::root, {}, {}, {1, 2, 3, 4}}}), text) << "there is none at 4";
  EXPECT_EQ(refusal({{Program::root, {}, {}, {}}, {Program::root, {}, {}, {}}}),
            "R: duplicate: the order names this state twice");
  EXPECT_EQ(Order::of(run->program(), {{StateId{4}, {}, {}, {}}}).error().code, ErrorCode::out_of_range);
}

TEST(Order, FitsTheProgramThatItWasMadeForAndDeclaredFitsAny) {
  SmallRun run(kLists), other(R"({'state': 'R'})");
  const Order order = Order::reversed(run->program());
  EXPECT_TRUE(order.fits(run->program()));
  EXPECT_FALSE(order.fits(other->program()));
  EXPECT_TRUE(Order::declared().fits(other->program()));
}

TEST(PTrigger, TakesTheFirstFulfilledPortInTheOrderOfTheStep) {
  SmallRun run(R"({'state': 'R', 'first': 'A', 'children': [{'state': 'A', 'ports': [
    {'name': 'p', 'when': 'svc.t.a'}, {'name': 'q', 'when': 'svc.t.a'}, {'name': 'r', 'when': 'svc.t.b'}]}]})");
  run.step();
  EXPECT_THAT(event(run, "a", Order::reversed(run->program())), ElementsAre("SProp R, PTrigger A.q, SDeact2 A"));
}

// A and B alternate; the response stays latched. When A is active for the second time, p has fired and both of its
// ports are fulfilled.
const std::string kP = "{'name': 'p', 'when': 'svc.t.f.result', 'to': 'B'}";
const std::string kQ = "{'name': 'q', 'when': 'par.n == 1', 'to': 'C'}";
std::string alternating_with_ports(const std::string& first, const std::string& second) {
  return R"({'state': 'R', 'entry': 'svc.t.f()', 'first': 'A',
  'variables': [{'name': 'n', 'initial': 0}], 'children': [
    {'state': 'A', 'parameters': [{'name': 'n', 'from': 'var.n'}], 'ports': [)" +
         first + ", " + second + R"(]},
    {'state': 'B', 'ports': [{'name': 'back', 'when': 'True', 'to': 'A'}]}, {'state': 'C'}],
  'actions': [{'when': 'chi.B.active', 'do': 'var.n = 1'}]})";
}

TEST(PTrigger, HoldsBackThePortsThatComeLaterInTheOrderOfTheStep) {
  SmallRun declared(alternating_with_ports(kP, kQ)), reversed(alternating_with_ports(kP, kQ));
  declared.step();
  reversed.step();
  declared.result(1, 0);
  EXPECT_EQ(declared.active(), "R A") << "p holds back q";
  reversed->post_response(1, false, Value(0));
  reversed.step(Order::reversed(reversed->program()));
  EXPECT_EQ(reversed.active(), "R C") << "q comes before p";
}

TEST(PTrigger, InAnotherOrderFiresWhatTheDeclaredOneHeldBack) {
  SmallRun run(alternating_with_ports(kP, kQ));
  run.step();
  run.result(1, 0);
  ASSERT_EQ(run.active(), "R A");
  TreeRecorder tree;
  ASSERT_FALSE(run->micro(tree)) << "quiescent in declared order";
  EXPECT_TRUE(run->micro(tree, Order::reversed(run->program()))) << "but not in this one";
}

TEST(PTrigger, InDeclaredOrderFiresWhatAnotherOneHeldBack) {
  SmallRun run(alternating_with_ports(kQ, kP));
  run.step();
  run->post_response(1, false, Value(0));
  run.step(Order::reversed(run->program()));
  ASSERT_EQ(run.active(), "R A");
  NoRecorder nothing;
  EXPECT_TRUE(run->micro(nothing));
  EXPECT_EQ(run.get("parameters", "R/A", "n"), Value(1));
}

TEST(Action1, IsAppliedInTheOrderOfTheStep) {
  SmallRun run(R"({'state': 'R', 'variables': [{'name': 'n', 'initial': 0}], 'actions': [
    {'when': 'svc.t.a', 'do': 'var.n = 1'}, {'when': 'svc.t.a', 'do': 'var.n = 2'}, {'when': 'svc.t.a', 'do': 'var.n = var.n * 10'}]})");
  run.step();
  event(run, "a", Order::declared());
  EXPECT_EQ(run.get("variables", "R", "n"), Value(20));
  event(run, "a", *Order::of(run->program(), {{Program::root, {}, {1, 0, 2}, {}}}));
  EXPECT_EQ(run.get("variables", "R", "n"), Value(10));
  EXPECT_THAT(event(run, "a", *Order::of(run->program(), {{Program::root, {}, {2, 1, 0}, {}}})),
              ElementsAre("SProp R, Action1 R#2, Action1 R#1, Action1 R#0"));
  EXPECT_EQ(run.get("variables", "R", "n"), Value(1));
}

// b opens A, B and C at once; each has a port to another state.
const char* const kConcurrent = R"({'state': 'R', 'first': 'b', 'children': [
    {'barrier': 'b', 'to': ['A', 'B', 'C']},
    {'state': 'A', 'exit': 'svc.t.f(1)', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'X'}]},
    {'state': 'B', 'exit': 'svc.t.f(2)', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'Y'}]},
    {'state': 'C', 'exit': 'svc.t.f(3)', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'X'}]},
    {'state': 'X', 'parameters': [{'name': 'x', 'value': 1}], 'entry': 'svc.t.g(1)'}, {'state': 'Y', 'entry': 'svc.t.g(2)'}],
  'ports': [{'name': 'p', 'when': 'svc.t.b'}]})";

TEST(SProp, VisitsActiveChildrenInTheOrderOfTheStep) {
  SmallRun run(kConcurrent);
  run.step();
  event(run, "a", *Order::of(run->program(), {{Program::root, {}, {}, {5, 3, 1, 0, 2, 4}}}));
  const std::vector<std::string> calls = run.calls();
  ASSERT_GE(calls.size(), 3U);
  EXPECT_THAT((std::vector(calls.begin(), calls.begin() + 3)), ElementsAre("t.f(3)#1", "t.f(1)#2", "t.f(2)#3"));
}

TEST(PTrans1, TakesThePortsOfChildrenInTheOrderOfTheStep) {
  SmallRun run(kConcurrent);
  run.step();
  EXPECT_THAT(event(run, "a", *Order::of(run->program(), {{Program::root, {}, {}, {5, 4, 2, 3, 1, 0}}})),
              ElementsAre("SProp R, PTrigger B.p, SDeact2 B, PTrigger C.p, SDeact2 C, PTrigger A.p, SDeact2 A",
                          "PTrans1 R, SAct1 Y, SAct1 X, SAct2 X"));
}

TEST(SDeact2, LeavesChildrenInTheOrderOfTheStep) {
  SmallRun run(kConcurrent);
  run.step();
  EXPECT_THAT(event(run, "b", *Order::of(run->program(), {{Program::root, {}, {}, {5, 3, 0, 2, 4, 1}}})),
              ElementsAre("PTrigger R.p, SDeact2 R, SDeact1 Y, SDeact2 C, BDeact b, SDeact2 B, SDeact1 X, SDeact2 A"));
  EXPECT_THAT(run.calls(), ElementsAre("t.f(3)#1", "t.f(2)#2", "t.f(1)#3"));
}

TEST(PTrans2, OpensBarriersInTheOrderOfTheStepAndTheirDestinationsAsDeclared) {
  SmallRun run(R"({'state': 'R', 'first': 'a', 'children': [
    {'barrier': 'a', 'to': ['A', 'B']}, {'barrier': 'b', 'to': ['X', 'Y']}, {'barrier': 'c', 'to': ['Y', 'Z']},
    {'state': 'A', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'b'}]},
    {'state': 'B', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'c'}]},
    {'state': 'X'}, {'state': 'Y'}, {'state': 'Z'}]})");
  run.step();
  const std::vector<std::string> micro = event(run, "a", Order::reversed(run->program()));
  ASSERT_EQ(micro.size(), 3U);
  EXPECT_EQ(micro[2], "PTrans2 R, SAct1 Y, SAct1 Z, BDeact c, SAct1 X, SAct2 Y, BDeact b");
}

TEST(BAct3, AsksForArrivalsInTheOrderOfTheStepUpToTheFirstThatIsMissing) {
  SmallRun run(R"({'state': 'R', 'first': 'a', 'children': [
    {'barrier': 'a', 'to': ['A', 'B', 'C']},
    {'state': 'A', 'ports': [{'name': 'p', 'when': 'svc.t.b', 'to': 'j'}]},
    {'state': 'B', 'ports': [{'name': 'p', 'when': 'svc.t.b', 'to': 'j'}]},
    {'state': 'C', 'ports': [{'name': 'p', 'when': 'svc.t.a', 'to': 'j'}]},
    {'barrier': 'j', 'to': ['A']}]})");
  run.step();
  const auto asked = [&](const Order& order) {
    DrivenRun copy = *run;
    copy.post_event("t", "a", Value());
    NameRecorder names;
    copy.macro_step(names, order);
    return std::ranges::count(names.names, Rule::Activated);
  };
  EXPECT_EQ(asked(Order::declared()), 1) << "A.p is missing";
  EXPECT_EQ(asked(Order::reversed(run->program())), 2) << "C.p has arrived, B.p is missing";
}

}  // namespace
}  // namespace race::semantics
