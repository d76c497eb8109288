#include "server/control/stop_mark.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/value/json.h"
#include "server/store/files.h"

namespace race::server {

std::optional<Control::Stop> StopMark::read() const {
  if (std::error_code unknown; !std::filesystem::exists(path_, unknown) && !unknown) return std::nullopt;
  Control::Stop stop{"an unknown person", 0};
  const auto text = read_file(path_);
  const auto json = text ? parse_json(*text) : tl::unexpected(text.error());
  if (!json) return stop;
  if (const Value* by = json->find("by"); by && by->is_string()) stop.by = by->as_string();
  if (const Value* time = json->find("time"); time && time->is_integer()) stop.time = time->as_integer();
  return stop;
}

Expected<void> StopMark::write(const std::optional<Control::Stop>& stop) const {
  if (stop) return write_file(path_, to_json(Dict{{"by", stop->by}, {"time", stop->time}}), kOwnerAlone);
  std::error_code failed;
  std::filesystem::remove(path_, failed);
  if (failed) return unexpected(ErrorCode::io, failed.message(), path_);
  return {};
}

}  // namespace race::server
