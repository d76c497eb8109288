// race account ACTION: who may use a server, in its data folder: the first account, and one when nobody can log in any
// more. While a server runs on the folder, its admins do the same on its pages (/api/v1/accounts).
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "server/accounts/accounts.h"
#include "server/accounts/passwords.h"
#include "server/cell/component_groups.h"
#include "server/commands/command.h"
#include "server/commands/terminal_input.h"
#include "server/store/data_folder.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

struct Options {
  std::string action;
  std::vector<std::string> words;
  std::string data = "data", role = "observer", label = "script";
  std::vector<std::string> groups;
  double days = 0;
};

constexpr std::array<std::string_view, 5> kRoles = {"observer", "operator", "developer", "admin", "process"};
constexpr std::int64_t kDay = std::int64_t{24} * 60 * 60 * 1000;

// Typed twice on a terminal, else the first line of the standard input.
Expected<std::string> read_password(const std::string& account) {
  const NoEcho silent;
  ASSIGN_OR_RETURN(std::string password, read_input_line("Password: ", "password"));
  if (auto fine = Passwords::check(password, account); !fine) return tl::unexpected(std::move(fine).error());
  if (!is_terminal_input()) return password;
  ASSIGN_OR_RETURN(const std::string again, read_input_line("The same again: ", "password"));
  if (again != password) return unexpected(ErrorCode::conflict, "the two are not the same", "password");
  return password;
}

Expected<std::string> read_hash(const std::string& account) {
  ASSIGN_OR_RETURN(const std::string password, read_password(account));
  return Passwords().hash_here(password);
}

Expected<void> add(Accounts& accounts, const Options& options) {
  Account account{options.words[0], role_of(options.role).value(), options.groups, "", now_ms()};
  for (const std::string& group : account.groups)
    if (auto known = check_account_group(group); !known) return known;
  if (auto fine = account.check(); !fine) return fine;
  if (account.role != Role::process) {
    ASSIGN_OR_RETURN(account.password_hash, read_hash(account.name));
  }
  return accounts.add(account);
}

Expected<void> set_password(Accounts& accounts, const Options& options) {
  if (!accounts.find(options.words[0]))
    return unexpected(ErrorCode::not_found, "there is no account of this name", options.words[0]);
  ASSIGN_OR_RETURN(std::string hash, read_hash(options.words[0]));
  return accounts.change(options.words[0], {.password_hash = std::move(hash)});
}

Expected<void> set_role(Accounts& accounts, const Options& options) {
  return accounts.change(options.words[0], {.role = role_of(options.role).value()});
}

Expected<void> remove(Accounts& accounts, const Options& options) { return accounts.remove(options.words[0]); }

Expected<void> issue_token(Accounts& accounts, const Options& options) {
  const std::int64_t now = now_ms(),
                     expires = options.days > 0 ? now + static_cast<std::int64_t>(options.days) * kDay : 0;
  ASSIGN_OR_RETURN(const Accounts::Issued token, accounts.issue(options.words[0], options.label, now, expires));
  std::printf("%s\n", token.secret.c_str());
  return {};
}

Expected<void> list(Accounts& accounts, const Options&) {
  for (const Account& account : accounts.list()) {
    std::string groups;
    for (const std::string& group : account.groups) groups += (groups.empty() ? "" : ",") + group;
    std::printf("%-20s  %-9s  %s\n", account.name.c_str(), std::string(name(account.role)).c_str(), groups.c_str());
  }
  return {};
}

struct Action {
  std::string_view name;
  std::size_t words;
  Expected<void> (*execute)(Accounts&, const Options&);
};

constexpr std::array<Action, 6> kActions = {{{"list", 0, list},
                                             {"add", 1, add},
                                             {"password", 1, set_password},
                                             {"role", 1, set_role},
                                             {"token", 1, issue_token},
                                             {"remove", 1, remove}}};

Expected<const Action*> find_action(const Options& options) {
  for (const Action& action : kActions) {
    if (action.name != options.action) continue;
    if (action.words == options.words.size()) return &action;
    return unexpected(ErrorCode::syntax,
                      "the form is `race account " + options.action + (action.words == 0 ? "`" : " NAME`"), "ACTION");
  }
  std::string known;
  for (const Action& action : kActions) known += (known.empty() ? "" : ", ") + std::string(action.name);
  return unexpected(ErrorCode::syntax, "must be one of " + known + "; got " + quote(options.action), "ACTION");
}

int run(const Options& options) {
  const auto action = find_action(options);
  if (!action) return refuse(action.error());
  const auto folder = DataFolder::take(options.data);
  if (!folder) return refuse(folder.error());
  const auto accounts = Accounts::open(folder->accounts());
  if (!accounts) return refuse(accounts.error());
  if (const auto done = (*action)->execute(**accounts, options); !done) return refuse(done.error());
  return kExitOk;
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.positional("ACTION", options->action,
                       "list, add NAME, password NAME, role NAME, token NAME (prints it), remove NAME");
  std::vector<std::string> names;
  for (const Action& action : kActions) names.emplace_back(action.name);
  arguments.suggest("ACTION", std::move(names));
  arguments.positionals("NAME", options->words, false);
  arguments.text("--data", "DIR", options->data, "of the server, which does not run meanwhile");
  arguments.choice("--role", "ROLE", options->role, kRoles,
                   "of add and role: observer, operator, developer, admin; each may do what those before it may; or "
                   "process, of services, which needs --groups");
  arguments.names("--groups", "GROUP,...", options->groups,
                  "of a process: the component groups that it may bring: " + component_group_names() +
                      ", own: services of one's own; local: of people, a display at the cell");
  arguments.text("--label", "TEXT", options->label, "of token: what it is for");
  arguments.number("--days", "N", options->days, {0, 3650, true}, "of token: how long it is good; 0: for ever");
  return [options] { return run(*options); };
}

}  // namespace

const Command kAccount = {
    "account", "shows and changes who may use a server; a password is read from the terminal or the standard input",
    declare};

}  // namespace race::server
