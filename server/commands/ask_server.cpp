#include "server/commands/ask_server.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "core/language/primitives/utf8.h"
#include "core/value/json.h"
#include "server/accounts/local_key.h"
#include "server/commands/command.h"
#include "server/commands/kept_token.h"
#include "server/log/line_log.h"

namespace race::server {
namespace {

// Of the environment; empty: it is not set.
std::string variable(const char* name) {
  const char* const given = std::getenv(name);
  return given ? given : "";
}

std::string text_of(const Value& error, std::string_view field) {
  const Value* text = error.find(field);
  return text && text->is_string() ? in_one_line(text->as_string()) : std::string();
}

// Prints errors of the server (schemas/errors.json) as refuse() prints our own. Its codes may be of the HTTP layer.
void print_errors(const HttpClient::Answer& answer, const std::string& file) {
  const Value* errors = answer.body.find("errors");
  if (!errors || !errors->is_list()) {
    std::fprintf(stderr, "the server answers %d\n", answer.status);
    return;
  }
  const std::string before = file.empty() ? "" : file + ": ";
  for (const Value& error : errors->as_list())
    std::fprintf(stderr, "%s%s: %s: %s\n", before.c_str(), text_of(error, "path").c_str(),
                 text_of(error, "code").c_str(), text_of(error, "message").c_str());
  if (answer.body.find("more_errors")) std::fprintf(stderr, "%s%s\n", before.c_str(), kMoreErrors);
}

// Who names the authority wants to be sure of the server: without TLS nothing would be checked. RACE_CA is for all
// servers, also those of this machine.
std::optional<Error> refuse_authority(const ServerOptions& server) {
  if (!server.authority || server.url.starts_with("https://")) return std::nullopt;
  return Error{ErrorCode::not_accepted,
               "is of https, and " + quote(server.url) +
                   " is not: nothing would be checked, and all is sent in the "
                   "clear. Write `--server https://ADDRESS:8443`, or leave `--ca` out",
               "--ca"};
}

enum class TokenSource : std::uint8_t { none, file, variable, login };

struct Token {
  TokenSource source = TokenSource::none;
  std::string secret;
};

Expected<Token> find_token(const ServerOptions& server) {
  if (server.anonymous) return Token();
  ASSIGN_OR_RETURN(std::string given, token_of(server.token_file));
  if (server.token_file) return Token{TokenSource::file, std::move(given)};
  if (!given.empty()) return Token{TokenSource::variable, std::move(given)};
  ASSIGN_OR_RETURN(const auto kept, KeptTokens::of_user().find(server.url));
  return kept ? Token{TokenSource::login, kept->token} : Token();
}

// Of who is not known to the server: which token was sent, and what helps.
void print_login_hint(const ServerOptions& server) {
  const auto token = find_token(server);
  const std::string where = server.url == kDefaultServer ? "" : " --server " + server.url,
                    authority = server.authority ? " --ca " + *server.authority : "",
                    login = "`race login" + where + authority + '`';
  std::string hint = login + " logs you in";
  if (token && token->source == TokenSource::file)
    hint = "the token in " + *server.token_file + " has ended, or is of another server";
  else if (token && token->source == TokenSource::variable)
    hint = "the token in RACE_TOKEN has ended, or is of another server; without it, " + hint;
  else if (token && token->source == TokenSource::login)
    hint = "your login has ended: " + login + " again";
  std::fprintf(stderr, "%s\n", hint.c_str());
}

}  // namespace

std::string in_one_line(std::string_view text) {
  const std::string known = as_utf8(text);
  std::string line;
  for (std::size_t at = 0; at < known.size();) {
    const char32_t c = language::utf8::next(known, at);
    language::utf8::append(is_control(c) ? U' ' : c, line);
  }
  return line;
}

Expected<std::string> token_of(const std::optional<std::string>& file) {
  if (file) return read_token_file(*file);
  return variable("RACE_TOKEN");
}

void ServerOptions::declare_place(Arguments& arguments) {
  arguments.text("--server", "URL", url, "where the server is");
  arguments.text("--ca", "FILE", authority,
                 "of https alone, else refused: the authority of the server, tls/ca.pem of its data folder; else that "
                 "in RACE_CA, else those "
                 "that this machine trusts");
}

void ServerOptions::declare_place(Arguments& arguments, const std::string& json_help) {
  declare_place(arguments);
  arguments.flag("--json", json, json_help);
}

void ServerOptions::declare(Arguments& arguments) {
  declare_place(arguments);
  arguments.text("--token-file", "FILE", token_file,
                 "the token of your account; else that in RACE_TOKEN, else that of `race login` at this server");
}

void ServerOptions::declare(Arguments& arguments, const std::string& json_help) {
  declare(arguments);
  arguments.flag("--json", json, json_help);
}

Expected<HttpClient> client_of(const ServerOptions& server, HttpClient::Timeouts timeouts) {
  auto client = HttpClient::create(server.url, timeouts);
  if (!client) return unexpected(client.error().code, client.error().message, "--server");
  if (auto plain = refuse_authority(server)) return tl::unexpected(std::move(*plain));
  ASSIGN_OR_RETURN(Token token, find_token(server));
  client->set_token(std::move(token.secret));
  client->set_authority(server.authority.value_or(variable("RACE_CA")));
  return client;
}

tl::expected<HttpClient::Answer, int> request_server(const ServerOptions& server, std::string_view method,
                                                     const std::string& target, const std::optional<Value>& body,
                                                     const HttpClient::Headers& headers) {
  const auto client = client_of(server);
  if (!client) return tl::unexpected(refuse(client.error(), server.json));
  auto answer = client->request(method, target, body, headers);
  if (!answer) return tl::unexpected(refuse(answer.error(), server.json));
  return std::move(*answer);
}

int refuse_answer(const ServerOptions& server, const HttpClient::Answer& answer, const std::string& file) {
  if (server.json) std::printf("%s\n", to_json(answer.body, 1).c_str());
  print_errors(answer, file);
  if (answer.status == 401 && !server.anonymous) print_login_hint(server);
  return kExitFindings;
}

int refuse_connection(const ServerOptions& server, const Error& error) {
  const int code = refuse(error, server.json);
  if (error.code != ErrorCode::rights) return code;
  print_login_hint(server);
  return kExitFindings;
}

tl::expected<Value, int> ask_server(const ServerOptions& server, std::string_view method, const std::string& target,
                                    const std::optional<Value>& body) {
  auto answer = request_server(server, method, target, body);
  if (!answer) return tl::unexpected(answer.error());
  if (is_fine(*answer)) return std::move(answer->body);
  return tl::unexpected(refuse_answer(server, *answer));
}

}  // namespace race::server
