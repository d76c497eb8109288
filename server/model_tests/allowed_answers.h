// Which answers an RSM allows a service to give to a call that waits. Pure.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/rsm/rules.h"

namespace race::server {

/// One way to answer a call: spontaneous transitions in this order, of which the last alone answers anything.
struct AllowedAnswer {
  std::vector<std::string> transitions;
  bool is_error = false;  // that the transition declares, with `error_code`
  std::string error_code;
  bool operator==(const AllowedAnswer&) const = default;
};

/// All by which the instance may answer `call`, over the shortest way to each state, shorter ways first. None: it does
/// not wait, or only another call's transition answers it (such as `stop`).
std::vector<AllowedAnswer> allowed_answers(const rsm::Service& service, const rsm::Instance& instance,
                                           std::uint64_t call);

/// Whether a transition of the instance has the response of `call` to give.
bool is_pending(const rsm::Instance& instance, std::uint64_t call);

}  // namespace race::server
