// Micro steps of an execution whose goals ask what each of them has done, or stop before it.
#include <algorithm>
#include <utility>

#include "core/execution/execution.h"

namespace race::execution {

using semantics::Run;
using semantics::TreeRecorder;

namespace {

/// Records micro steps one by one, each for itself.
class Facts final : public semantics::TurnWatch {
 public:
  explicit Facts(TreeRecorder& trees)
      : trees_(trees), nodes_(trees.derivation.nodes.size()), calls_(trees.derivation.calls.size()) {
    trees_.watch = this;
  }
  ~Facts() override { trees_.watch = nullptr; }
  void port(semantics::PortId p) override { tested_.push_back(p); }

  /// What was recorded since this was made.
  MicroStepFacts get(bool changed) const {
    const semantics::Derivation& derivation = trees_.derivation;
    return {changed, std::span(derivation.nodes).subspan(nodes_), std::span(derivation.calls).subspan(calls_), tested_};
  }

 private:
  TreeRecorder& trees_;
  std::size_t nodes_, calls_;
  std::vector<semantics::PortId> tested_;
};

}  // namespace

bool Execution::needs_facts() const {
  return (goal_ && goal_->needs_facts()) || std::ranges::any_of(breakpoints_, &GoalWatch::needs_facts);
}

void Execution::do_watched_micro_steps(TreeRecorder& trees, std::uint32_t limit) {
  while (limit-- > 0) {
    if (stops_before_micro_step()) {
      progress_.reached_goal = true;
      return;
    }
    Facts facts(trees);
    const bool changed = run_.micro(trees, order_);
    if (changed) note_micro_step();
    const MicroStepFacts done = facts.get(changed);
    const bool goes_on = goes_on_after(&done);
    open_ = changed && run_.status() == semantics::Status::running;
    if (!open_ || !goes_on) return;
  }
}

// The micro step is done on a copy of the run, to see.
bool Execution::stops_before_micro_step() {
  const auto is_before = [](const GoalWatch& goal) { return goal.goal().before; };
  if (!(goal_ && is_before(*goal_)) && std::ranges::none_of(breakpoints_, is_before)) return false;
  Run ahead = run_;
  TreeRecorder trees;
  Facts facts(trees);
  const bool changed = ahead.micro(trees, order_);
  return any_goal([&, seen = facts.get(changed)](GoalWatch& goal) { return goal.stops_before(run_, ahead, seen); });
}

}  // namespace race::execution
