#include "server/handlers/account_json.h"

#include <string>

#include "server/http/refusal.h"

namespace race::server {

Value account_json(const Account& account) {
  Dict json{{"name", account.name}, {"role", std::string(name(account.role))}, {"created", account.created}};
  List groups;
  for (const std::string& group : account.groups) groups.push_back(group);
  if (!account.groups.empty()) json.set("groups", std::move(groups));
  return json;
}

Value token_json(const AccountToken& token) {
  Dict json{{"digest", token.digest}, {"label", token.label}, {"created", token.created}};
  if (token.expires != 0) json.set("expires", token.expires);
  if (token.scope.role) json.set("role", std::string(name(*token.scope.role)));
  if (token.scope.local) json.set("local", true);
  if (!token.scope.display.empty()) json.set("name", token.scope.display);
  return json;
}

std::optional<Role> read_role(Fields& fields, Fields::Need need) {
  const auto text = fields.text("role", need);
  if (!text) return std::nullopt;
  const auto role = role_of(*text);
  if (!role)
    fields.violation(ErrorCode::out_of_range, "`role` must be observer, operator, developer, admin or process", "role");
  return role;
}

Reply too_many_attempts(std::chrono::milliseconds wait) {
  const std::string seconds = std::to_string(std::chrono::ceil<std::chrono::seconds>(wait).count());
  Reply reply = refusal(429, "attempts", "too many logins or codes have failed; try again in " + seconds + " s");
  reply.headers.emplace_back("Retry-After", seconds);
  reply.is_routine = true;
  return reply;
}

void settle(Attempts& attempts, const Attempts::Attempt& attempt, const Expected<bool>& is_right) {
  const auto now = std::chrono::steady_clock::now();
  if (!is_right) return attempts.drop(attempt, now);
  if (*is_right) attempts.succeed(attempt, now);
}

}  // namespace race::server
