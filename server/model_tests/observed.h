// What a run of a test has done, as expectations see it.
#pragma once

#include <string>
#include <vector>

#include "core/value/value.h"

namespace race::server {

struct SeenCall {
  double time = 0;  // s of world time
  std::string service, operation;
  List args;
  Dict kwargs;
};

struct FiredPort {
  double time = 0;
  std::string port;  // Root/A.success
};

struct Observed {
  std::vector<FiredPort> ports;
  std::vector<SeenCall> calls;
  std::string status, outcome, fault;  // outcome: of one that ended; fault: why it is faulted
  Dict results;
  double time = 0;                    // world time at the end
  std::vector<std::string> problems;  // of mocks: what was listed and their RSMs do not allow
};

}  // namespace race::server
