// Gate: who asks, and whether they may. Every request passes it once its header is there, and every message of a client
// of the stream; what has no row in the table of rights is denied.
//
// Threads: any; waits for no disk.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "server/accounts/accounts.h"
#include "server/accounts/local_key.h"
#include "server/accounts/rights.h"
#include "server/accounts/tickets.h"

namespace race::server {

/// Why a request is not served.
struct Denial {
  bool is_unknown = false;  // nobody is known to ask (401); else somebody who may not (403)
  std::string code;         // "login", "rights"
  std::string message;
};

/// The author of a change, of which its maker says that it is `author`: their account, or one of their pages,
/// `NAME~PAGE`, as people undo what they did on one page; if they say nothing, the account. Without accounts authors
/// are whatever clients say. Error `rights`, with the path `author`: it is somebody else.
Expected<std::string> author_for(const Identity& identity, std::string author);

class Gate {
 public:
  /// What a request says of who sends it.
  struct Credentials {
    std::string_view authorization;  // the header, empty: absent
    std::string_view ticket;         // of the query, of a WebSocket
  };

  /// All outlive this.
  Gate(const Accounts& accounts, const LocalKey& key, Tickets& tickets)
      : accounts_(accounts), key_(key), tickets_(tickets) {}

  /// Who sends it, if that is known and may use the route `pattern`: one without a row is denied to everybody. An empty
  /// pattern, of a request that has no route, needs only that somebody is known. Without accounts anybody is an admin,
  /// but no process.
  tl::expected<Identity, Denial> admit(std::string_view method, std::string_view pattern,
                                       const Credentials& credentials) const;
  /// Whether an identity that was admitted still is what it was: a WebSocket that is open ends otherwise.
  bool is_current(const Identity& identity) const;

 private:
  std::optional<Identity> identify(const Credentials& credentials) const;

  const Accounts& accounts_;
  const LocalKey& key_;
  Tickets& tickets_;
};

}  // namespace race::server
