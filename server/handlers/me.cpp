// GET /api/v1/me: who asks, and whether the server has accounts. PUT /api/v1/me/password: a new one of one's own. POST
// /api/v1/tickets: what opens a WebSocket.
#include <chrono>

#include "server/accounts/accounts.h"
#include "server/accounts/attempts.h"
#include "server/accounts/passwords.h"
#include "server/accounts/tickets.h"
#include "server/handlers/account_json.h"
#include "server/handlers/body.h"
#include "server/handlers/handlers.h"
#include "server/http/refusal.h"

namespace race::server {
namespace {

struct NewPassword {
  std::string old, password;
};

Checked<NewPassword> read_passwords(const Request& request) {
  auto passwords = read_body(request.body, [](Fields& fields) {
    return NewPassword{fields.text("old", kRequired).value_or(""), fields.text("password", kRequired).value_or("")};
  });
  if (!passwords) return passwords;
  if (auto fine = Passwords::check(passwords->password, request.identity.account); !fine)
    return failed(std::move(fine).error());
  return passwords;
}

Reply wrong_old_password() { return refusal(403, "password", "the old password is another one"); }

// `old`: the hash of the old password when it was compared.
Handled set_password(const std::string& account, const std::string& old, const Expected<std::string>& hash,
                     Accounts& accounts) {
  if (!hash) return failed(hash.error());
  auto changed = accounts.change(account, {.password_hash = *hash, .old_password_hash = old});
  if (!changed && changed.error().code == ErrorCode::conflict) return wrong_old_password();  // by now
  if (!changed) return failed(std::move(changed).error());
  return ok(Dict());
}

}  // namespace

Handled get_me(const Request& request, Accounts& accounts) {
  Dict json{{"accounts", !accounts.empty()}};
  const bool is_known = !request.identity.account.empty() || accounts.empty();
  if (!request.identity.account.empty()) json.set("name", request.identity.account);
  if (is_known) json.set("role", std::string(name(request.identity.role)));
  if (is_known) json.set("local", is_local(request.identity));
  return ok(std::move(json));
}

// The old password counts as an attempt: a token that somebody has found must not become a password.
void change_password(const Request& request, Respond respond, Accounts& accounts, Passwords& passwords,
                     Attempts& attempts) {
  const std::string account = request.identity.account, address = request.identity.address;
  const auto known = accounts.find(account);
  if (!known) return respond(failed({ErrorCode::not_found, "who has no account has no password"}));
  auto read = read_passwords(request);
  if (!read) return respond(tl::unexpected(std::move(read).error()));
  const auto now = std::chrono::steady_clock::now();
  const auto attempt = attempts.begin(address, account, now);
  if (!attempt) return respond(too_many_attempts(attempt.error()));
  auto hashed = [respond, account, old = known->password_hash, &accounts](const Expected<std::string>& hash) {
    respond(set_password(account, old, hash, accounts));
  };
  auto compared = [respond, attempt = *attempt, next = read->password, hashed, &passwords,
                   &attempts](const Expected<bool>& same) {
    settle(attempts, attempt, same);
    if (!same) return respond(failed(same.error()));
    if (!*same) return respond(wrong_old_password());
    passwords.hash(next, hashed);
  };
  passwords.compare(std::move(read->old), known->password_hash, std::move(compared));
}

Handled create_ticket(const Request& request, Tickets& tickets) {
  Reply reply = ok(Dict{{"ticket", tickets.issue(request.identity, std::chrono::steady_clock::now())}});
  reply.is_routine = true;
  return reply;
}

}  // namespace race::server
