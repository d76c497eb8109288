// StopMark: a file that outlives the server: a cell that was stopped is stopped after a restart, too.
//
// Threads: one at a time.
#pragma once

#include <optional>
#include <string>

#include "core/value/expected.h"
#include "server/control/control.h"

namespace race::server {

class StopMark {
 public:
  explicit StopMark(std::string path) : path_(std::move(path)) {}
  /// What is in the file; nothing: there is none. One that cannot be read is a stop, too.
  std::optional<Control::Stop> read() const;
  /// Makes it as the control is; nothing: there is no file. Error `io`.
  Expected<void> write(const std::optional<Control::Stop>& stop) const;

 private:
  const std::string path_;
};

}  // namespace race::server
