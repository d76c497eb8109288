// Exceptions that threads of ours report (services/failures.h) are findings.
#pragma once

#include <cstdio>
#include <cstdlib>

#include "services/failures.h"

namespace race::fuzz {

inline void end_at_failures() {
  services::set_failure_handler([](const std::string& text) {
    std::fprintf(stderr, "%s\n", text.c_str());
    std::abort();
  });
}

}  // namespace race::fuzz
