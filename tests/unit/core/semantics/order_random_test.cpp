// On random models: a step in another order is the step, in declared order, of the model whose lists stand in that
// order; and the order may change at any micro step. RACE_SEED and RACE_ORDER_STEPS choose another run; both are
// printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <numeric>

#include "core/semantics/order.h"
#include "core/value/json.h"
#include "tests/unit/core/semantics/driven_run.h"
#include "tests/unit/core/semantics/random_models.h"
#include "tests/unit/core/semantics/random_runs.h"
#include "tests/unit/setting.h"

namespace race::semantics {
namespace {

using Positions = std::vector<std::uint32_t>;

// Declared positions of the ports, actions and children of each state, by path, in another order.
struct Lists {
  Positions ports, actions, children;
};
using ListsByPath = std::map<std::string, Lists>;

Positions declared(std::size_t size) {
  Positions positions(size);
  std::iota(positions.begin(), positions.end(), 0U);
  return positions;
}

// Every declared list, changed by `reorder`.
template <typename Reorder>
ListsByPath reordered(const Program& program, Reorder reorder) {
  ListsByPath out;
  for (const StateInfo& s : program.states) {
    Lists lists{declared(s.ports.size()), declared(s.actions.size()), declared(s.children.size())};
    for (Positions* list : {&lists.ports, &lists.actions, &lists.children}) reorder(*list);
    out[s.path] = std::move(lists);
  }
  return out;
}

// What an order says, for those that are not made from lists.
ListsByPath lists_of(const Program& program, const Order& order) {
  ListsByPath out;
  for (std::uint32_t i = 0; i < program.states.size(); ++i) {
    const StateInfo& s = program.states[i];
    Lists lists;
    for (const PortId p : order.ports(program, StateId{i})) lists.ports.push_back(index(p) - s.ports.low);
    for (const ActionId a : order.actions(program, StateId{i})) lists.actions.push_back(a - s.actions.low);
    for (const NodeRef c : order.children(program, StateId{i})) {
      const auto same = [&](const NodeRef d) { return c.barrier == d.barrier && c.number == d.number; };
      lists.children.push_back(static_cast<std::uint32_t>(std::ranges::find_if(s.children, same) - s.children.begin()));
    }
    out[s.path] = lists;
  }
  return out;
}

Order order_of(const Program& program, const ListsByPath& lists) {
  std::vector<Order::OfState> states;
  for (std::uint32_t i = 0; i < program.states.size(); ++i) {
    const Lists& of_state = lists.at(program.states[i].path);
    states.push_back({StateId{i}, of_state.ports, of_state.actions, of_state.children});
  }
  return *Order::of(program, states);
}

rcm::Port port_to(const std::string& barrier) {
  rcm::Port port;
  port.name = port.to.emplace(barrier);
  port.when = "svc.t.e0";
  return port;
}

// Random models seldom have two barriers that are active at once. These have, when S0 and S1 are left together.
void add_barriers(rcm::State& root) {
  std::vector<rcm::State*> states;
  for (rcm::Node& node : root.children)
    if (auto* child = std::get_if<rcm::State>(&node)) states.push_back(child);
  if (states.size() < 2) return;
  states[0]->ports.push_back(port_to("x"));
  states[1]->ports.push_back(port_to("y"));
  rcm::Barrier x{"x", {"S0", "S1"}, {}}, y{"y", {"S1"}, {}};
  root.first = "x";
  root.children.emplace_back(std::move(x));
  root.children.emplace_back(std::move(y));
}

template <typename T>
void permute(std::vector<T>& list, const Positions& positions) {
  std::vector<T> out;
  for (const std::uint32_t position : positions) out.push_back(list[position]);
  list = std::move(out);
}

// The model whose lists stand in the order.
void permute(rcm::State& s, const std::string& path, const ListsByPath& lists) {
  for (rcm::Node& node : s.children)
    if (auto* child = std::get_if<rcm::State>(&node)) permute(*child, path + "/" + child->name, lists);
  const Lists& own = lists.at(path);
  permute(s.ports, own.ports);
  permute(s.actions, own.actions);
  permute(s.children, own.children);
}

// A derivation of the permuted model with the numbers that the actions have in the other one.
Value with_declared_actions(const Value& node, const ListsByPath& lists) {
  Dict out = node.as_dict();
  if (const Value* action = node.find("action")) {
    const Positions& actions = lists.at(node.find("at")->as_string()).actions;
    out.set("action", static_cast<std::int64_t>(actions[static_cast<std::size_t>(action->as_integer())]));
  }
  List premises;
  for (const Value& premise : node.find("premises")->as_list())
    premises.push_back(with_declared_actions(premise, lists));
  out.set("premises", std::move(premises));
  return out;
}

List sorted(const Value& list) {
  List out = list.as_list();
  std::ranges::sort(out, {}, [](const Value& v) { return v.as_string(); });
  return out;
}

// The state of a run, in which nothing stands in the order of its model.
Value unordered_state(const Run& run) {
  const Value json = run.state_json();
  Dict state = json.as_dict();
  for (const char* list : {"active", "ports"}) state.set(list, sorted(*json.find(list)));
  Dict activated;
  for (const auto& [barrier, ports] : json.find("activated")->as_dict())
    activated.set(barrier.as_string(), sorted(ports));
  state.set("activated", std::move(activated));
  return state;
}

// Calls, with the caller and the operation by name.
std::vector<std::string> calls(DrivenRun& run) {
  std::vector<std::string> out;
  for (const OutgoingCall& call : run.take_calls())
    out.push_back(std::to_string(call.number) + " " + call.service + "." + call.name + to_json(Value(call.args)) +
                  to_json(Value(call.kwargs)) + " by " +
                  (call.caller == kNoState ? "the run" : run.program()[call.caller].path));
  return out;
}

std::string end_of(const Run& run) {
  std::string out(name(run.status()));
  if (const auto& fault = run.fault())
    out += " " + fault->at + " " + fault->message + " " + std::to_string(fault->where.line) + ":" +
           std::to_string(fault->where.column);
  return out + " " + run.outcome();
}

struct Steps {
  std::uint64_t macro = 0, micro = 0, differing = 0;
};

// A model, an order of it, and the model whose lists stand in that order.
struct Pair {
  std::shared_ptr<const Program> program, permuted;
  ListsByPath lists;
  Order order;
};

Pair make_pair(RandomModels& random, std::uint64_t seed) {
  rcm::NativeModel model = random.model();
  if (random.chance(0.3)) add_barriers(model.root);
  Pair pair{*Program::build(model, RandomModels::services()), nullptr, {}, Order::declared()};
  std::mt19937_64 shuffling(seed);
  switch (random.pick(4)) {
    case 0:
      pair.lists = reordered(*pair.program, [](Positions& list) { std::ranges::reverse(list); });
      pair.order = Order::reversed(*pair.program);
      break;
    case 1:
      pair.order = Order::random(*pair.program, seed);
      pair.lists = lists_of(*pair.program, pair.order);
      break;
    default:
      pair.lists = reordered(*pair.program, [&](Positions& list) { std::ranges::shuffle(list, shuffling); });
      pair.order = order_of(*pair.program, pair.lists);
  }
  permute(model.root, model.root.name, pair.lists);
  pair.permuted = *Program::build(model, RandomModels::services());
  return pair;
}

DrivenRun new_run(std::shared_ptr<const Program> program) {
  Budgets budgets;
  budgets.micro_steps = 300;
  return DrivenRun(*Run::create(std::move(program), {}, budgets));
}

// Runs of a pair with the same inputs: of the model in the order, recording trees or names; of the permuted model in
// declared order, likewise; and of the model in declared order.
class Comparison {
 public:
  explicit Comparison(const Pair& pair) : pair_(pair) {}

  bool is_running() const { return ordered_.status() == Status::running; }
  void post(RandomModels& random) {
    random.post<DrivenRun>({&ordered_, &named_, &permuted_, &permuted_named_, &declared_}, ordered_.state().call_count);
  }
  // One macro step, if there is an input.
  void step(Steps& steps) {
    ASSERT_EQ(ordered_.has_input(), permuted_.has_input());
    if (!ordered_.has_input()) return;
    ++steps.macro;
    for (DrivenRun* run : {&ordered_, &named_, &permuted_, &permuted_named_}) run->begin(run->take_input());
    TreeRecorder tree, permuted_tree;
    NameRecorder names, permuted_names;
    while (ordered_.micro(tree, pair_.order)) {
      ++steps.micro;
      ASSERT_TRUE(permuted_.micro(permuted_tree) && named_.micro(names, pair_.order) &&
                  permuted_named_.micro(permuted_names));
      compare_states();
      compare_trees(tree.derivation, permuted_tree.derivation);
      if (testing::Test::HasFatalFailure()) return;
    }
    ASSERT_FALSE(permuted_.micro(permuted_tree) || named_.micro(names, pair_.order) ||
                 permuted_named_.micro(permuted_names));
    compare_states();
    ASSERT_EQ(names.names, permuted_names.names);
    compare_calls();
    NoRecorder nothing;
    if (declared_.has_input()) declared_.macro_step(nothing);
    differs = differs || ordered_.state().values != declared_.state().values;
  }

  bool differs = false;  // the run in the order from that in declared order

 private:
  void compare_states() {
    ASSERT_TRUE(unordered_state(ordered_) == unordered_state(permuted_));
    ASSERT_TRUE(same(ordered_.state(), named_.state()));
    ASSERT_EQ(end_of(ordered_), end_of(permuted_));
    ASSERT_EQ(end_of(ordered_), end_of(named_));
  }
  // Those of the last micro step.
  void compare_trees(const Derivation& ordered, const Derivation& permuted) {
    const std::size_t last = ordered.micro.size() - 1;
    const Value derived = derivation_json(*pair_.program, ordered, last);
    const Value expected = with_declared_actions(derivation_json(*pair_.permuted, permuted, last), pair_.lists);
    ASSERT_TRUE(derived == expected) << to_json(derived) << "\n" << to_json(expected);
  }
  void compare_calls() {
    const std::vector<std::string> called = calls(ordered_);
    ASSERT_EQ(called, calls(permuted_));
    ASSERT_EQ(called, calls(named_));
  }

  const Pair& pair_;
  DrivenRun ordered_ = new_run(pair_.program), named_ = ordered_, declared_ = ordered_;
  DrivenRun permuted_ = new_run(pair_.permuted), permuted_named_ = permuted_;
};

void compare_with_permuted_model(std::uint64_t seed, int limit, Steps& steps) {
  RandomModels random(seed);
  const Pair pair = make_pair(random, seed);
  Comparison comparison(pair);
  for (int i = 0; i < limit && comparison.is_running(); ++i) {
    if (i > 0) comparison.post(random);
    comparison.step(steps);
    if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed << ", step " << i;
  }
  steps.differing += comparison.differs ? 1 : 0;
}

TEST(RandomOrders, StepAsTheModelWhoseListsStandInThatOrder) {
  const std::uint64_t seed = setting("RACE_SEED", 328), limit = setting("RACE_ORDER_STEPS", 5'000);
  std::cout << "RACE_SEED=" << seed << " RACE_ORDER_STEPS=" << limit << std::endl;
  Steps steps;
  std::uint64_t models = 0;
  for (; steps.macro < limit; ++models) {
    compare_with_permuted_model(seed + models, 40, steps);
    if (HasFatalFailure()) return;
  }
  std::cout << models << " models, " << steps.macro << " macro steps, " << steps.micro << " micro steps, "
            << steps.differing << " models that depend on the order" << std::endl;
  EXPECT_GT(steps.differing, models / 50);
}

// Three runs of one model: one that evaluates all, one that records trees, and one that records nothing whenever the
// order is the declared one.
void change_orders(std::uint64_t seed, int limit, Steps& steps) {
  RandomModels random(seed);
  const auto program = *Program::build(random.model(), RandomModels::services());
  const std::array orders = {Order::declared(), Order::declared(), Order::reversed(*program),
                             Order::random(*program, seed)};
  DrivenRun thorough = new_run(program), recorded = thorough, fast = thorough;
  for (int i = 0; i < limit && thorough.status() == Status::running; ++i) {
    if (i > 0 && random.chance(0.8)) random.post<DrivenRun>({&thorough, &recorded, &fast}, thorough.state().call_count);
    for (DrivenRun* run : {&thorough, &recorded, &fast}) run->begin(run->take_input());
    ++steps.macro;
    for (bool more = true; more;) {
      const Order& order = orders[random.pick(orders.size())];
      NameRecorder all;
      TreeRecorder tree;
      NoRecorder nothing;
      more = thorough.micro(all, order);
      ASSERT_EQ(recorded.micro(tree, order), more) << "seed " << seed << ", step " << i;
      ASSERT_EQ(order.is_declared() ? fast.micro(nothing) : fast.micro(tree, order), more)
          << "seed " << seed << ", step " << i;
      ASSERT_TRUE(same(thorough.state(), recorded.state())) << "seed " << seed << ", step " << i;
      ASSERT_TRUE(same(thorough.state(), fast.state())) << "seed " << seed << ", step " << i;
      steps.micro += more ? 1 : 0;
    }
  }
}

TEST(RandomOrders, MayChangeAtAnyMicroStep) {
  const std::uint64_t seed = setting("RACE_SEED", 329), limit = setting("RACE_ORDER_STEPS", 5'000);
  std::cout << "RACE_SEED=" << seed << " RACE_ORDER_STEPS=" << limit << std::endl;
  Steps steps;
  for (std::uint64_t i = 0; steps.macro < limit; ++i) {
    change_orders(seed + i, 40, steps);
    if (HasFatalFailure()) return;
  }
  std::cout << steps.macro << " macro steps, " << steps.micro << " micro steps" << std::endl;
}

}  // namespace
}  // namespace race::semantics
