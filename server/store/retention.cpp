#include "server/store/retention.h"

namespace race::server {

Expected<std::size_t> apply_retention(Runs& runs, const RetentionLimits& limits,
                                      const std::function<bool(RunId)>& is_hosted) {
  ASSIGN_OR_RETURN(const auto sizes, runs.sizes());
  std::size_t number = 0, removed = 0;
  std::uint64_t bytes = 0;
  for (const auto& [id, size] : sizes) {
    ++number;
    bytes += size;
    if ((number <= limits.runs && bytes <= limits.bytes) || is_hosted(id)) continue;
    if (auto done = runs.remove(id); !done && done.error().code != ErrorCode::not_found)
      return tl::unexpected(std::move(done).error());
    ++removed;
  }
  return removed;
}

}  // namespace race::server
