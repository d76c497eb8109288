// RunningCall: a call from its arrival until its handler has ended.
//
// Threads: any.
#pragma once

#include <atomic>
#include <string>
#include <utility>

#include "core/rsm/model.h"
#include "services/component.h"

namespace race::client {

class Workers;

struct RunningCall {
  RunningCall(Workers& its_workers, services::CallId its_id, std::string its_operation,
              const rsm::Transition* its_transition)
      : workers(its_workers), id(its_id), operation(std::move(its_operation)), transition(its_transition) {}

  Workers& workers;
  const services::CallId id;
  const std::string operation;
  const rsm::Transition* const transition;  // that took it; nullptr: the RSM is an interface, which has none
  std::atomic<bool> over{false};            // nobody waits for its answer any more; set by Workers::end()

  /// Whether its answer comes by a later transition, or by none: its handler may take its time.
  bool is_busy() const { return !transition || !transition->defer.empty(); }
};

}  // namespace race::client
