#include "server/application/access.h"

#include <algorithm>

#include "server/http/refusal.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

constexpr std::string_view kTicket = "ticket";

constexpr std::string_view kStopRoute = "/api/v1/stop";

bool changes_something(const Request& request) { return request.method != "GET" && request.method != "HEAD"; }

Reply denied(const Denial& denial) {
  Reply reply = refusal(denial.is_unknown ? 401 : 403, denial.code, denial.message);
  if (denial.is_unknown) reply.headers.emplace_back("WWW-Authenticate", "Bearer");
  return reply;
}

Reply behind() {
  Reply reply = refusal(503, "overload", "the audit log is behind");
  reply.headers.emplace_back("Retry-After", "1");
  return reply;
}

bool is_by_limit(const Reply& reply) {
  return reply.status == 429 ||
         std::ranges::any_of(reply.headers, [](const auto& header) { return header.first == "Retry-After"; });
}

std::string ticket_of(const Request& request) {
  const auto ticket = request.query.find(kTicket);
  return ticket == request.query.end() ? std::string() : ticket->second;
}

}  // namespace

bool Access::is_login(std::string_view pattern) { return pattern == "/api/v1/login" || pattern == "/api/v1/pair"; }

tl::expected<Identity, Reply> Access::admit(const Request& request) const {
  if (request.count("authorization") > 1) return tl::unexpected(refusal(400, "login", "Authorization stands twice"));
  const std::string ticket = ticket_of(request);
  auto identity =
      gate_.admit(request.method, pattern_of_(request.method, request.path), {request.header("authorization"), ticket});
  if (!identity) return tl::unexpected(denied(identity.error()));
  // No disk keeps anybody from stopping the cell; who did may then be missing in the log.
  const bool waits_for_log = changes_something(request) && request.path != kStopRoute;
  if (waits_for_log && !audit_.has_room()) return tl::unexpected(behind());
  identity->address = request.identity.address;
  return std::move(*identity);
}

Answer Access::audited(const Request& request, const Answer& answer) {
  if (!changes_something(request)) return answer;
  AuditEntry entry;
  entry.account = request.identity.account;
  entry.address = request.identity.address;
  entry.action = request.method + ' ' + request.path;
  const bool brings_token = is_login(pattern_of_(request.method, request.path));
  return Answer([this, brings_token, entry = std::move(entry), answer](Reply reply) mutable {
    entry.time = now_ms();
    entry.outcome = std::to_string(reply.status);
    if (reply.logged_in) entry.account = *reply.logged_in;
    if (has_row(brings_token, reply)) audit_.append(std::move(entry));
    answer(std::move(reply));
  });
}

bool Access::take(Bucket& bucket, int burst) {
  const auto now = std::chrono::steady_clock::now();
  const auto until = std::max(bucket, now) + kRowTime;
  if (until > now + burst * kRowTime) return false;
  bucket = until;
  return true;
}

bool Access::has_row(bool brings_token, const Reply& reply) {
  if (reply.is_routine) return false;
  if (reply.status < 400) return true;
  if (is_by_limit(reply)) return false;
  const services::MutexLock lock(mutex_);
  if (!brings_token) return reply.status >= 500 || take(refusals_, kRefusalRows);
  return reply.status == 401 && take(logins_, kLoginRows);
}

void Access::record_stop(const Identity& identity, const Reply& reply) {
  if (reply.is_routine) {
    const services::MutexLock lock(mutex_);
    if (!take(stops_, kStopRows)) return;
  }
  record(identity, "POST " + std::string(kStopRoute), std::to_string(reply.status));
}

void Access::record(const Identity& identity, std::string action, std::string outcome) {
  audit_.append({0, now_ms(), identity.account, identity.address, std::move(action), std::move(outcome)});
}

void Access::refused(const Identity& identity, const Error& why) {
  const std::string who = identity.account.empty() ? "a process" : "the process " + quote(identity.account);
  log_(who + " at " + identity.address + " is refused: " + to_string(why));
  {
    const services::MutexLock lock(mutex_);
    if (!take(refusals_, kRefusalRows)) return;
  }
  record(identity, "process " + why.path, std::string(name(why.code)));
}

}  // namespace race::server
