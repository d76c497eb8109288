// The table of rights, api/rights.json: what each route, channel and message of clients needs. What has no row is
// denied to everybody.
//
// Threads: any; read once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/value/expected.h"
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

/// Whether this identity has the right that `what` needs, a name for people; nothing: everybody is denied. Error
/// `rights`.
Expected<void> check_right(const Identity& identity, std::string_view what, std::optional<Right> right);
/// Whether it may send a message of this type, or subscribe to the channel of this name. Errors: `rights`; `not_found`:
/// no channel has a row for that.
Expected<void> check_message(const Identity& identity, std::string_view type);
Expected<void> check_channel(const Identity& identity, std::string_view name);

}  // namespace race::server
