// The inputs of a run that wait, in order of arrival (R5): one for each macro step.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/semantics/run.h"

namespace race::execution {

class WaitingInputs {
 public:
  /// An input that counts (Run::counts) waits at the end. Of a sampled event only the newest occurrence waits.
  void add(const semantics::Program& program, semantics::Input&& input);
  /// Takes the first that still counts; a response that another call has overtaken does not. Requires that the run is
  /// running.
  std::optional<semantics::Input> take(const semantics::Run& run);
  /// Whether take() would give one.
  bool any(const semantics::Run& run) const;
  /// Whether an occurrence of `event` waits.
  bool contains(semantics::EventId event) const;
  std::size_t size() const { return inputs_.size() - taken_; }
  void clear();

 private:
  void drop_taken();
  void drop_occurrences(semantics::EventId event);

  // OPTIMIZATION: a queue that keeps its memory. The first `taken_` have been taken.
  std::vector<semantics::Input> inputs_;
  std::size_t taken_ = 0;
};

}  // namespace race::execution
