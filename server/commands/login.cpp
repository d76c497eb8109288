// race login [NAME] and race logout: a token of the server for a password, kept for the commands that ask this server
// (kept_token.h), and its end.
#include <arpa/inet.h>

#include <cstdio>
#include <ctime>
#include <limits>
#include <memory>
#include <optional>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/commands/ask_server.h"
#include "server/commands/command.h"
#include "server/commands/kept_token.h"
#include "server/commands/terminal_input.h"
#include "services/remote/address.h"

namespace race::server {
namespace {

struct Options {
  std::optional<std::string> name;
  ServerOptions server;
};

// By its address: a name that begins with 127. may be of any machine.
bool is_this_machine(const std::string& host) {
  in_addr address{};
  return host == "localhost" ||
         (::inet_pton(AF_INET, host.c_str(), &address) == 1 && ntohl(address.s_addr) >> 24U == IN_LOOPBACKNET);
}

// A password does not go through a network for all to read.
Expected<void> check_secrecy(const std::string& url) {
  ASSIGN_OR_RETURN(const remote::Address address, remote::read_address(url));
  if (address.tls || is_this_machine(address.host)) return {};
  return unexpected(ErrorCode::not_accepted,
                    "a password goes to another machine by https alone: `--server https://ADDRESS:8443 --ca ca.pem`",
                    "--server");
}

// That of the command line, else of the login before, else what a person types.
Expected<std::string> find_name(const Options& options, const KeptTokens& tokens) {
  if (options.name) return *options.name;
  const auto kept = tokens.find(options.server.url);
  if (kept && *kept) return (*kept)->account;
  if (!is_terminal_input()) return unexpected(ErrorCode::missing, "the name of an account is needed", "NAME");
  return read_input_line("Account: ", "name");
}

// schemas/login_answer.json. Error `io`: it is none.
Expected<KeptToken> read_answer(const Value& answer) {
  std::vector<Error> errors;
  Fields fields(answer, "", "the answer", errors);
  const auto token = fields.text("token", kRequired);
  const auto expires = fields.integer("expires", 0, std::numeric_limits<std::int64_t>::max(), kRequired);
  std::optional<std::string> name;
  if (const Value* account = fields.find("account", kRequired))
    name = Fields(*account, "", "the account", errors).text("name", kRequired);
  if (!errors.empty() || !name) return unexpected(ErrorCode::io, "answers what is no login");
  return KeptToken{*name, *token, *expires};
}

std::string date_of(std::int64_t time_ms) {
  const auto seconds = static_cast<std::time_t>(time_ms / 1000);
  std::tm parts{};
  char text[40] = "";
  if (::gmtime_r(&seconds, &parts)) std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M UTC", &parts);
  return text;
}

int log_in(const Options& options) {
  const ServerOptions& server = options.server;
  const bool json = server.json;
  // What is wrong there is said before somebody types.
  if (const auto client = client_of(server); !client) return refuse(client.error(), json);
  if (const auto secret = check_secrecy(server.url); !secret) return refuse(secret.error(), json);
  const KeptTokens tokens = KeptTokens::of_user();
  const auto name = find_name(options, tokens);
  if (!name) return refuse(name.error(), json);
  Expected<std::string> password = [] {
    const NoEcho silent;
    return read_input_line("Password: ", "password");
  }();
  if (!password) return refuse(password.error(), json);
  const auto answer = ask_server(server, "POST", "/api/v1/login", Dict{{"name", *name}, {"password", *password}});
  if (!answer) return answer.error();
  const auto token = read_answer(*answer);
  if (!token) return refuse(Error{token.error().code, token.error().message, server.url}, json);
  if (const auto kept = tokens.keep(server.url, *token); !kept) return refuse(kept.error(), json);
  if (json)
    std::printf("%s\n", to_json(Dict{{"account", token->account}, {"expires", token->expires}}, 1).c_str());
  else
    std::printf("logged in as %s, until %s\n", in_one_line(token->account).c_str(), date_of(token->expires).c_str());
  return kExitOk;
}

// A token that the server does not know any more has ended already.
int log_out(const Options& options) {
  ServerOptions server = options.server;
  server.anonymous = true;
  auto client = client_of(server);
  if (!client) return refuse(client.error(), server.json);
  const KeptTokens tokens = KeptTokens::of_user();
  const auto kept = tokens.find(server.url);
  if (!kept) return refuse(kept.error(), server.json);
  if (!*kept) {
    refuse(Error{ErrorCode::not_found, "you are not logged in at this server", server.url}, server.json);
    return kExitFindings;
  }
  client->set_token((*kept)->token);
  const auto answer = client->request("POST", "/api/v1/logout");
  if (!answer) return refuse(answer.error(), server.json);
  if (!is_fine(*answer) && answer->status != 401 && answer->status != 404) return refuse_answer(server, *answer);
  const auto removed = tokens.remove(server.url);
  return removed ? kExitOk : refuse(removed.error(), server.json);
}

std::function<int()> declare_login(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  options->server.anonymous = true;
  arguments.positional("NAME", options->name, "your account; else that of the login before");
  options->server.declare_place(arguments, "prints account and end [ms since 1970] as JSON");
  return [options] { return log_in(*options); };
}

std::function<int()> declare_logout(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  options->server.declare_place(arguments, "prints errors as JSON, too");
  return [options] { return log_out(*options); };
}

}  // namespace

const Command kLogin = {
    "login", "logs in at a server: reads the password from the terminal or the standard input, keeps a token",
    declare_login};
const Command kLogout = {"logout", "ends the token that `race login` keeps for a server", declare_logout};

}  // namespace race::server
