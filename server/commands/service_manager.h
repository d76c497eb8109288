// The service manager that has started this process (systemd, Type=notify): what it is told, as sd_notify(3) does.
//
// Threads: one.
#pragma once

#include <string_view>

namespace race::server {

/// Sends `state` ("READY=1") to the socket that $NOTIFY_SOCKET names: a path, or, beginning with @, an abstract name.
/// Nothing happens without one, or if nobody is there: a manager that hears nothing says so itself.
void notify_manager(std::string_view state);

}  // namespace race::server
