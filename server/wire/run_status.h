// The words for how a run stands (schemas/core.json, run.json: `status`).
#pragma once

#include <string_view>

namespace race::server {

/// Whether a run of this status is over.
constexpr bool is_over(std::string_view status) {
  return status == "ended" || status == "faulted" || status == "aborted";
}

}  // namespace race::server
