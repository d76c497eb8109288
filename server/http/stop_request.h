// The one request of the stop server: what is read of its header, and whether it stops the cell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace race::server {

/// Whom a stop server answers: the Host headers by which it is known, "localhost:8081", and the origins of pages whose
/// requests it takes, "http://localhost:8080"; in lower case.
struct StopNames {
  std::vector<std::string> hosts, origins;
};

/// What is answered to a header: 200, and the cell is stopped; else nothing happens: 400 (no HTTP), 404, 405, 421 (not
/// exactly one Host, or a foreign one), 403 (a foreign Origin).
struct StopAnswer {
  int status = 400;
  std::string origin;  // of the page that may read the answer; empty: none
};

/// `header`: all up to the empty line. What follows it is never read: a stop has no body that could be wrong.
StopAnswer answer_stop(std::string_view header, const StopNames& names);

/// The answer as it is sent; the connection ends with it.
std::string stop_response(const StopAnswer& answer);

}  // namespace race::server
