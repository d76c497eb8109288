// The inputs of a run that wait, in order of arrival (R5): one for each macro step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/semantics/run.h"

namespace race::execution {

class WaitingInputs {
 public:
  // An input that counts (Run::counts) waits at the end; of a sampled event only the newest occurrence. False: it does
  // not count, and is dropped.
  bool post_event(const semantics::Run& run, std::string_view service, std::string_view event, Value data);
  bool post_event(const semantics::Run& run, semantics::EventId event, Value data);
  bool post_response(const semantics::Run& run, std::uint64_t call, bool is_error, Value data);
  /// R7: `service` is lost; without one, all are. Every unanswered call to it gets the error `unavailable`, in order of
  /// call.
  void post_lost(const semantics::Run& run, std::optional<std::string_view> service);

  /// Takes the first that still counts; a response that another call has overtaken does not. Requires that the run is
  /// running.
  std::optional<semantics::Input> take(const semantics::Run& run);
  /// Whether take() would give one.
  bool any(const semantics::Run& run) const;
  /// `after` is the run `before`, edited: what its model does not name is dropped.
  void carry_over(const semantics::Run& before, const semantics::Run& after);
  /// Whether an occurrence of `event` waits.
  bool contains(semantics::EventId event) const;
  std::size_t size() const { return inputs_.size() - taken_; }
  /// In order of arrival; some may not count any more.
  std::span<const semantics::Input> inputs() const { return std::span(inputs_).subspan(taken_); }
  void clear();

 private:
  void add(const semantics::Program& program, semantics::Input&& input);
  void drop_taken();
  void drop_occurrences(semantics::EventId event);

  // OPTIMIZATION: a queue that keeps its memory. The first `taken_` have been taken.
  std::vector<semantics::Input> inputs_;
  std::size_t taken_ = 0;
};

}  // namespace race::execution
