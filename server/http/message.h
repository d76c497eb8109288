// Request and Reply: what the routes see of HTTP. The listener makes one from the other; sockets stay there.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/accounts/role.h"
#include "server/threads/stop.h"
#include "server/threads/work_progress.h"
#include "server/wire/path_pattern.h"

namespace race::server {

/// A parsed request. Header names are in lower case, each header as often as it came.
struct Request {
  std::string method;  // "GET"
  std::string path;    // decoded, begins with '/'
  Parameters query;    // decoded; the first of equal names
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;
  Parameters parameters;  // of the route, such as `id`
  Identity identity;      // who sends it; before it is admitted, its address alone
  /// Whether the client has closed the connection before it is answered, or its half of it: for what takes long.
  SharedStop gone = std::make_shared<Stop>(false);
  /// How far what is asked for has come; empty: nobody asks for that meanwhile.
  SharedWorkProgress progress = {};

  /// The header, empty if it is absent.
  std::string_view header(std::string_view name) const;
  std::size_t count(std::string_view name) const;
};

/// An answer that goes on: the messages of a channel of the stream, as Server-Sent Events (event_session.h).
struct ChannelEvents {
  std::string channel;                // "core/1/state"
  std::optional<std::int64_t> since;  // the client has all messages up to this number
};

/// An answer: JSON, or a text of another type.
struct Reply {
  int status = 200;
  Value body;
  std::string text, type;  // if `type` is not empty, the answer is `text`
  std::vector<std::pair<std::string, std::string>> headers;
  // For the audit log: one of so many that it would hold little else; and the name of who tried to log in.
  bool is_routine = false;
  std::optional<std::string> logged_in = {};
  std::optional<ChannelEvents> events = {};  // follow the header; there is no other content
};

/// The path and query of a request target, decoded. Error `syntax`: it is not of the form /path?query, or is
/// not properly encoded.
Expected<std::pair<std::string, Parameters>> parse_target(std::string_view target);

/// Whether it is a path of the interface (api/openapi.yaml), not of a page.
inline bool is_of_interface(std::string_view path) { return path.starts_with("/api/") || path == "/metrics"; }

}  // namespace race::server
