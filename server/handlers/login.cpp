// POST /api/v1/login: a password for a token. POST /api/v1/logout: the token of the request ends.
#include <chrono>

#include "server/accounts/accounts.h"
#include "server/accounts/attempts.h"
#include "server/accounts/passwords.h"
#include "server/handlers/account_json.h"
#include "server/handlers/body.h"
#include "server/handlers/handlers.h"
#include "server/http/refusal.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

struct Login {
  std::string name, password;
};

Login read_login(Fields& fields) {
  Login login{fields.text("name", kRequired).value_or(""), fields.text("password", kRequired).value_or("")};
  if (login.password.size() > Passwords::kLongest) login.password.clear();  // nobody's
  if (login.name.size() > Account::kLongestName) login.name.clear();
  return login;
}

// The same for a name that is none and a password that is wrong.
Reply wrong() {
  Reply reply = refusal(401, "login", "there is no account of this name with this password");
  reply.headers.emplace_back("WWW-Authenticate", "Bearer");
  return reply;
}

// `hash`: of the password that was right when it was compared.
Handled log_in_as(const std::string& name, const std::string& hash, Accounts& accounts) {
  const std::int64_t now = now_ms();
  const auto secret = accounts.issue_login(name, hash, now, now + kLoginLife);
  const auto account = accounts.find(name);
  if (!account || (!secret && has_changed(secret.error()))) return wrong();  // by now
  if (!secret) return failed(secret.error());
  return ok(Dict{{"token", secret->secret}, {"expires", now + kLoginLife}, {"account", account_json(*account)}});
}

// The audit log has the name, also of a login that fails.
Handled of(const std::string& name, Handled handled) {
  Reply reply = handled ? std::move(*handled) : refusal(handled.error());
  reply.logged_in = name;
  return reply;
}

}  // namespace

void log_in(const Request& request, Respond respond, Accounts& accounts, Passwords& passwords, Attempts& attempts) {
  auto login = read_body(request.body, read_login);
  if (!login) return respond(tl::unexpected(std::move(login).error()));
  const std::string name = login->name, address = request.identity.address;
  const auto now = std::chrono::steady_clock::now();
  const auto attempt = attempts.begin(address, name, now);
  if (!attempt) return respond(of(name, too_many_attempts(attempt.error())));
  const auto account = accounts.find(name);
  const std::string hash = account ? account->password_hash : "";
  auto compared = [respond = std::move(respond), attempt = *attempt, hash, &accounts,
                   &attempts](const Expected<bool>& same) {
    const std::string& name = attempt.account;
    settle(attempts, attempt, same);
    if (!same) return respond(of(name, failed(same.error())));
    respond(of(name, *same ? log_in_as(name, hash, accounts) : wrong()));
  };
  passwords.compare(std::move(login->password), hash, std::move(compared));
}

Handled log_out(const Request& request, Accounts& accounts) {
  if (request.identity.account.empty()) return ok(Dict());
  auto revoked = accounts.revoke(request.identity.account, request.identity.token);
  if (!revoked) return failed(std::move(revoked).error());
  return ok(Dict());
}

}  // namespace race::server
