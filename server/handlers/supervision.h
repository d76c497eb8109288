// Who begins a run, or lets it go on, as a request says.
#pragma once

#include "core/value/fields.h"
#include "server/control/manual_control.h"
#include "server/execution/core.h"
#include "server/http/message.h"

namespace race::server {

/// The header by which a request proves that its sender has the controls of the cell: the secret of the message
/// `taken`.
inline constexpr std::string_view kControlHeader = "race-control";

/// The number of who sends the request, if they have the controls; 0: they do not say so. Error `leased`: they have
/// them no more.
inline Expected<std::uint64_t> control_of(const Request& request, const ManualControl& manual) {
  return manual.number_of(request.header(kControlHeader));
}

}  // namespace race::server
