// Access: accounts and rights in front of all that the sockets serve, and the audit log behind it.
//
// Threads: any; waits for no disk.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "server/accounts/audit_log.h"
#include "server/accounts/gate.h"
#include "server/http/answer.h"
#include "server/http/listener.h"
#include "server/stream/requests.h"
#include "services/mutex.h"

namespace race::server {

class Access final : public ClientRecords {
 public:
  /// The pattern of the route of a request; empty: there is none.
  using PatternOf = std::string_view (*)(std::string_view method, std::string_view path);
  using Log = std::function<void(const std::string& text)>;
  /// All outlive this. `log` gets a line of each process that is refused.
  Access(const Gate& gate, AuditLog& audit, PatternOf pattern_of, Log log)
      : gate_(gate), audit_(audit), pattern_of_(pattern_of), log_(std::move(log)) {}

  /// Who sends the request, if they may: else 401 or 403, and 503 while the audit log has no room for what changes
  /// something, but for a stop of the cell.
  tl::expected<Identity, Reply> admit(const Request& request) const;
  /// An answer that is also a row of the audit log, if the request changes something and is not routine.
  Answer audited(const Request& request, const Answer& answer);
  /// Whether the route of this pattern brings a token to who has none: for a password, or a code of a pairing.
  static bool is_login(std::string_view pattern);
  /// Whoever reaches the server can send logins and stops without an account, as often as they like, and who has one,
  /// what is refused. These have so many rows at once, then one in kRowTime of each: logins whose password or code is
  /// wrong, stops of a cell that is stopped already, and all other refusals. Logins whose password was not looked at
  /// have none, and neither has what a limit refuses, which says when to try again (429, Retry-After). So nobody pushes
  /// out what others have done within a month.
  static constexpr int kLoginRows = 100, kStopRows = 1, kRefusalRows = 100;
  static constexpr std::chrono::seconds kRowTime{60};
  /// A stop of the cell, which the sockets' threads answer without a handler.
  void record_stop(const Identity& identity, const Reply& reply) EXCLUDES(mutex_);

  bool is_current(const Identity& identity) const override { return gate_.is_current(identity); }
  void record(const Identity& identity, std::string action, std::string outcome) override;
  void refused(const Identity& identity, const Error& why) override;

 private:
  /// A bucket, known by when it will be full again.
  using Bucket = std::chrono::steady_clock::time_point;
  static bool take(Bucket& bucket, int burst);
  bool has_row(bool brings_token, const Reply& reply) EXCLUDES(mutex_);

  const Gate& gate_;
  AuditLog& audit_;
  const PatternOf pattern_of_;
  const Log log_;
  services::Mutex mutex_;
  Bucket logins_ GUARDED_BY(mutex_), stops_ GUARDED_BY(mutex_), refusals_ GUARDED_BY(mutex_);
};

}  // namespace race::server
