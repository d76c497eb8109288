// Commands that watch what goes on at a server: how often they ask, and how a person ends them.
#pragma once

#include <chrono>
#include <string>

namespace race::server {

/// Between two requests: five a second at most.
inline constexpr std::chrono::milliseconds kPollPause{200};

/// Status of a server that has too much to do: ask again.
inline constexpr int kBusy = 503;

/// From now on, SIGINT (Ctrl-C) and SIGTERM end the program at once with this exit code, whatever it waits for, after
/// `farewell` on stderr; what was printed stays. For commands that watch alone: nothing is left half done. Requires one
/// thread.
void end_on_signal(int code, const std::string& farewell = "");

}  // namespace race::server
