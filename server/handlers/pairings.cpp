// POST /api/v1/pairings: a code with which a phone gets a token. POST /api/v1/pair: the token for the code.
#include "server/accounts/pairings.h"

#include <chrono>

#include "server/accounts/accounts.h"
#include "server/accounts/attempts.h"
#include "server/handlers/account_json.h"
#include "server/handlers/body.h"
#include "server/handlers/handlers.h"
#include "server/handlers/network_addresses.h"
#include "server/http/refusal.h"
#include "server/wire/calendar.h"
#include "services/display/screens.h"

namespace race::server {
namespace {

constexpr std::int64_t kMostDays = 365, kUsualDays = 30;

Reply no_accounts() {
  return refusal(409, "no_accounts",
                 "this server has no accounts: who reaches it, on its machine alone, needs no code");
}

// The name of a display, or of a place.
std::string read_display_name(Fields& fields, std::string_view key, Fields::Need need) {
  std::string text = fields.text(key, need).value_or("");
  if (fields.find(key) && !display::is_display_name(text))
    fields.violation(ErrorCode::name, "a name has 1 to 32 letters, digits, `_` and `-`, and is not `all`", key);
  return text;
}

// Who stands at the cell shows the code to a phone that does, too, and an admin says who does.
bool may_make_local(const Identity& identity) { return is_local(identity) || identity.role == Role::admin; }

// Who asks is an operator at least, so nobody hands on more than they have.
Pairing read_pairing(Fields& fields, const Identity& by) {
  Pairing pairing{by, {std::nullopt, may_make_local(by)}};
  const auto role = fields.text("role", kRequired);
  if (role) pairing.scope.role = role_of(*role);
  if (role && pairing.scope.role != Role::observer && pairing.scope.role != Role::cell_operator)
    fields.violation(ErrorCode::out_of_range, "`role` must be observer or operator", "role");
  pairing.scope.display = read_display_name(fields, "name", kRequired);
  pairing.place = read_display_name(fields, "place", Fields::Need::optional);
  pairing.days = fields.integer("days", 1, kMostDays).value_or(kUsualDays);
  return pairing;
}

Reply too_many_codes(const Pairings::Full& full) {
  const std::string seconds = std::to_string(std::chrono::ceil<std::chrono::seconds>(full.wait).count());
  const std::string codes = std::to_string(full.most) + (full.of_account ? " codes of the account" : " codes");
  Reply reply = refusal(429, "too_many", codes + " wait to be used already");
  reply.headers.emplace_back("Retry-After", seconds);
  return reply;
}

// The same for a code that is none, was used, is too old, or of somebody who may no more.
Reply wrong_code() {
  Reply reply = refusal(401, "pairing", "the code is wrong, was used, or is older than a minute: ask for another one");
  reply.headers.emplace_back("WWW-Authenticate", "Bearer");
  return reply;
}

// schemas/pair_answer.json
Reply paired(const Pairing& pairing, const Accounts::Issued& token, std::int64_t expires, const Account& account) {
  Dict json{{"token", token.secret},
            {"expires", expires},
            {"account", account_json(account)},
            {"role", std::string(name(*pairing.scope.role))},
            {"name", pairing.scope.display}};
  if (!pairing.place.empty()) json.set("place", pairing.place);
  Reply reply = ok(std::move(json));
  reply.logged_in = account.name;
  return reply;
}

}  // namespace

Handled create_pairing(const Request& request, Accounts& accounts, Pairings& pairings, NetworkAddresses& addresses) {
  if (accounts.empty()) return no_accounts();
  // Otherwise a phone that is lost would let others in, and itself beyond its time.
  if (!request.identity.display.empty())
    return refusal(403, "rights", "a display that was let in with a code lets nobody in");
  auto pairing = read_body(request.body, [&](Fields& fields) { return read_pairing(fields, request.identity); });
  if (!pairing) return tl::unexpected(std::move(pairing).error());
  const auto code = pairings.issue(std::move(*pairing), std::chrono::steady_clock::now());
  if (!code) return too_many_codes(code.error());
  Reply reply = ok(Dict{
      {"code", *code}, {"expires_s", std::int64_t{Pairings::kLife.count()}}, {"addresses", addresses_json(addresses)}});
  reply.status = 201;
  return reply;
}

Handled pair_display(const Request& request, Accounts& accounts, Pairings& pairings, Attempts& attempts) {
  if (accounts.empty()) return no_accounts();
  const auto code = read_body(request.body, [](Fields& fields) { return fields.text("code", kRequired).value_or(""); });
  if (!code) return tl::unexpected(code.error());
  const auto time = std::chrono::steady_clock::now();
  const auto attempt = attempts.begin(request.identity.address, "", time);
  if (!attempt) return too_many_attempts(attempt.error());
  const auto pairing = pairings.take(*code, time);
  if (!pairing) return wrong_code();
  const std::int64_t now = now_ms(), expires = now + pairing->days * kDay;
  const auto token = accounts.issue_for(pairing->by, "phone: " + pairing->scope.display, now, expires, pairing->scope);
  const auto account = accounts.find(pairing->by.account);
  if (!account || (!token && has_changed(token.error()))) return wrong_code();
  attempts.drop(*attempt, time);
  if (!token) return failed(token.error());
  return paired(*pairing, *token, expires, *account);
}

}  // namespace race::server
