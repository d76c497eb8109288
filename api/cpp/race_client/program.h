// Services as a program: its command line, its connection, which is made again when it is lost, and its end.
#pragma once

#include <vector>

#include "api/cpp/race_client/hosted.h"

namespace race::client {

/// run() of service.h.
int run_program(int argc, char** argv, const std::vector<Hosted*>& services);

}  // namespace race::client
