// /api/v1/accounts: who may use the server: list, create, change and remove.
#include "server/accounts/accounts.h"

#include "core/value/json.h"
#include "server/accounts/passwords.h"
#include "server/cell/component_groups.h"
#include "server/handlers/account_json.h"
#include "server/handlers/handlers.h"
#include "server/http/encode_part.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

// Of an account that is created: `name` comes from the body; of one that is changed, from the path.
struct Wanted {
  std::string name;
  std::optional<Role> role;
  std::optional<std::vector<std::string>> groups;
  std::optional<std::string> password;
};

void check_groups(const std::vector<std::string>& groups, Fields& fields) {
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (const auto known = check_account_group(groups[i]); !known)
      fields.violation(ErrorCode::out_of_range, known.error().message, "groups/" + std::to_string(i));
}

Checked<Wanted> read_wanted(const Request& request, bool creates) {
  const auto body = parse_json(request.body);
  if (!body) return failed(body.error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  Wanted wanted;
  wanted.name = creates ? fields.text("name", Fields::Need::required).value_or("") : request.parameters.at("name");
  wanted.role = read_role(fields, creates ? Fields::Need::required : Fields::Need::optional);
  if (fields.find("groups")) wanted.groups = fields.texts("groups");
  if (wanted.groups) check_groups(*wanted.groups, fields);
  wanted.password = fields.text("password");
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  if (wanted.password)
    if (auto fine = Passwords::check(*wanted.password, wanted.name); !fine) return failed(std::move(fine).error());
  return wanted;
}

Handled create(const Wanted& wanted, const std::string& hash, Accounts& accounts) {
  const Account account{wanted.name, *wanted.role, wanted.groups.value_or(std::vector<std::string>()), hash, now_ms()};
  if (auto added = accounts.add(account); !added) return failed(std::move(added).error());
  return created(account_json(account), "/api/v1/accounts/" + encode_part(account.name));
}

Handled change(const Wanted& wanted, const std::optional<std::string>& hash, Accounts& accounts) {
  if (auto changed = accounts.change(wanted.name, {wanted.role, wanted.groups, hash}); !changed)
    return failed(std::move(changed).error());
  return ok(account_json(accounts.find(wanted.name).value_or(Account{wanted.name})));
}

}  // namespace

Handled list_accounts(const Request&, Accounts& accounts) {
  List list;
  for (const Account& account : accounts.list()) list.push_back(account_json(account));
  return ok(Dict{{"accounts", std::move(list)}});
}

void create_account(const Request& request, Respond respond, Accounts& accounts, Passwords& passwords) {
  auto wanted = read_wanted(request, true);
  if (!wanted) return respond(tl::unexpected(std::move(wanted).error()));
  if (!wanted->password) return respond(create(*wanted, "", accounts));
  passwords.hash(*wanted->password, [respond, wanted = *wanted, &accounts](const Expected<std::string>& hash) {
    respond(hash ? create(wanted, *hash, accounts) : failed(hash.error()));
  });
}

void change_account(const Request& request, Respond respond, Accounts& accounts, Passwords& passwords) {
  auto wanted = read_wanted(request, false);
  if (!wanted) return respond(tl::unexpected(std::move(wanted).error()));
  if (!wanted->password) return respond(change(*wanted, std::nullopt, accounts));
  passwords.hash(*wanted->password, [respond, wanted = *wanted, &accounts](const Expected<std::string>& hash) {
    respond(hash ? change(wanted, *hash, accounts) : failed(hash.error()));
  });
}

Handled remove_account(const Request& request, Accounts& accounts) {
  const std::string& name = request.parameters.at("name");
  if (auto removed = accounts.remove(name); !removed) return failed(std::move(removed).error());
  return ok(Dict{{"removed", name}});
}

}  // namespace race::server
