// The table of rights, api/rights.json: what each route, channel and message of clients needs. What has no row is
// denied to everybody.
//
// Threads: any; read once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "server/accounts/role.h"

namespace race::server {

class Rights {
 public:
  /// The table of this version.
  static const Rights& table();

  /// `pattern` as in the table of routes: "/api/v1/cores/{id}". Nothing: everybody is denied.
  std::optional<Right> of_route(std::string_view method, std::string_view pattern) const;
  /// Of a subscription to the channel of this name ("core/1/state"), by its pattern.
  std::optional<Right> of_channel(std::string_view name) const;
  /// Of a message of a client of the stream, by its type.
  std::optional<Right> of_message(std::string_view type) const;

  using Rows = std::map<std::string, Right, std::less<>>;
  /// By "METHOD PATTERN", pattern, and type: for tests that compare them with what there is.
  const Rows& routes() const { return routes_; }
  const Rows& channels() const { return channels_; }
  const Rows& messages() const { return messages_; }

 private:
  Rows routes_, channels_, messages_;
};

}  // namespace race::server
