// ModeMark: a file that keeps the mode of the cell over a restart of the server.
//
// Threads: one at a time.
#pragma once

#include <string>

#include "core/value/expected.h"
#include "server/control/control.h"

namespace race::server {

class ModeMark {
 public:
  explicit ModeMark(std::string path) : path_(std::move(path)) {}
  /// What is in the file; without one, `execution`. One that cannot be read is the mode in which less moves:
  /// `programming`.
  Mode read() const;
  /// Error `io`.
  Expected<void> write(Mode mode) const;

 private:
  const std::string path_;
};

}  // namespace race::server
