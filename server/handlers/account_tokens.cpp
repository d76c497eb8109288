// /api/v1/accounts/{name}/tokens: the tokens of an account: list, create, revoke.
#include "core/value/json.h"
#include "server/accounts/accounts.h"
#include "server/handlers/account_json.h"
#include "server/handlers/handlers.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

constexpr std::int64_t kLongestLife = 3650;  // days

}  // namespace

Handled list_account_tokens(const Request& request, Accounts& accounts) {
  const std::string& name = request.parameters.at("name");
  if (!accounts.find(name)) return failed({ErrorCode::not_found, "there is no account of this name", name});
  List list;
  for (const AccountToken& token : accounts.tokens(name, now_ms())) list.push_back(token_json(token));
  return ok(Dict{{"tokens", std::move(list)}});
}

Handled create_account_token(const Request& request, Accounts& accounts) {
  const auto body = parse_json(request.body);
  if (!body) return failed(body.error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const std::string label = fields.text("label", Fields::Need::required).value_or("");
  const auto days = fields.integer("days", 1, kLongestLife);
  const TokenScope scope{read_role(fields, Fields::Need::optional), fields.boolean("local").value_or(false)};
  if (label == Accounts::kLogin)
    fields.violation(ErrorCode::not_accepted, "`login` is what tokens of passwords are called", "label");
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  const std::int64_t now = now_ms(), expires = days ? now + *days * kDay : 0;
  const auto secret = accounts.issue(request.parameters.at("name"), label, now, expires, scope);
  if (!secret) return failed(secret.error());
  Dict json{{"token", secret->secret}, {"digest", secret->digest}};
  if (expires != 0) json.set("expires", expires);
  Reply reply = ok(std::move(json));
  reply.status = 201;
  return reply;
}

Handled revoke_account_token(const Request& request, Accounts& accounts) {
  const std::string& digest = request.parameters.at("digest");
  if (auto revoked = accounts.revoke(request.parameters.at("name"), digest); !revoked)
    return failed(std::move(revoked).error());
  return ok(Dict{{"removed", digest}});
}

}  // namespace race::server
