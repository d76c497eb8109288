// A Run with the inputs that wait for it, driven by a test with any recorder.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/execution/waiting_inputs.h"
#include "core/semantics/run.h"

namespace race::semantics {

class DrivenRun : public Run {
 public:
  explicit DrivenRun(Run run) : Run(std::move(run)) {}

  bool post_event(std::string_view service, std::string_view event, Value data) {
    return inputs_.post_event(*this, service, event, std::move(data));
  }
  bool post_response(std::uint64_t call, bool is_error, Value data) {
    return inputs_.post_response(*this, call, is_error, std::move(data));
  }
  bool post_event(EventId event, Value data) { return inputs_.post_event(*this, event, std::move(data)); }
  void post_lost(std::string_view service) { inputs_.post_lost(*this, service); }
  /// Something waits, or the root has not been activated.
  bool has_input() const { return status() == Status::running && (!state().started || inputs_.any(*this)); }
  std::optional<Input> take_input() { return inputs_.take(*this); }

  std::vector<OutgoingCall> take_calls() {
    std::vector<OutgoingCall> calls;
    std::vector<std::string> printed;
    take_output(calls, printed);
    return calls;
  }

  /// With the first waiting input.
  template <Recorder R>
  void macro_step(R& recorder, const Order& order = Order::declared()) {
    begin(take_input());
    quiesce(recorder, order, ~0U, [] { return true; });
  }

 private:
  execution::WaitingInputs inputs_;
};

}  // namespace race::semantics
