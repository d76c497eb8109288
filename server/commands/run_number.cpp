#include "server/commands/run_number.h"

#include <charconv>

namespace race::server {

Expected<RunId> read_run_number(const std::string& text, const std::string& path) {
  RunId id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc() || end != text.data() + text.size())
    return unexpected(ErrorCode::type, "with --data, the number of a run", path);
  return id;
}

}  // namespace race::server
