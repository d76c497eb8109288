// The destinations of a transition (3.28, 3.29), and their parameters.
#pragma once

#include <utility>

#include "core/semantics/atomic.h"

namespace race::semantics {

inline NodeRef destination(const Program& program, PortId p) { return program[p].to; }
inline NodeRef destination(const Program&, StateId d) { return {false, index(d)}; }

/// Resolves the parameters of a destination, if it is an inactive state and they have not been resolved in this
/// transition.
template <Recorder R>
void resolve_once(Step<R>& step, NodeRef d) {
  if (d.barrier || step.is_active(d.state())) return;
  std::uint64_t& resolved_in = step.live(d.state()).resolved_in;
  if (std::exchange(resolved_in, step.run.transitions) != step.run.transitions) resolve_parameters(step, d.state());
}

/// REFINEMENT R23: the parameters of all destinations are resolved before any of them is activated, so that these do
/// not depend on each other's order. In a derivation they stand where their destination is activated.
template <Recorder R>
class ResolvedDestinations {
 public:
  /// Resolves what a transition along `ways` needs: ports, or destinations themselves.
  template <typename Ways>
  ResolvedDestinations(Step<R>& step, const Ways& ways) : program_(step.program), nodes_(resolve(step, ways)) {}

  /// The parameters of the destination of `way` become premises at this place.
  template <typename Way>
  void add_premises(Way way) {
    nodes_.insert(program_.flag(destination(program_, way)));
  }

 private:
  template <typename Ways>
  static auto resolve(Step<R>& step, const Ways& ways) {
    const auto mark = step.recorder.mark();
    ++step.run.transitions;
    for (const auto way : ways) resolve_once(step, destination(step.program, way));
    return step.recorder.postpone(mark);
  }

  const Program& program_;
  decltype(std::declval<R&>().postpone(std::declval<typename R::Mark>())) nodes_;
};

}  // namespace race::semantics
