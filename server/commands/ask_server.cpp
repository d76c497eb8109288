#include "server/commands/ask_server.h"

#include <cstdio>
#include <cstdlib>

#include "core/value/json.h"
#include "server/accounts/local_key.h"
#include "server/commands/command.h"
#include "server/http/client.h"

namespace race::server {
namespace {

// Of the environment; empty: it is not set.
std::string variable(const char* name) {
  const char* const given = std::getenv(name);
  return given ? given : "";
}

std::string text_of(const Value& error, std::string_view field) {
  const Value* text = error.find(field);
  return text && text->is_string() ? text->as_string() : std::string();
}

// Prints errors of the server (schemas/errors.json) as refuse() prints our own. Its codes may be of the HTTP layer.
void print_errors(const HttpClient::Answer& answer, bool json) {
  if (json) std::printf("%s\n", to_json(answer.body, 1).c_str());
  const Value* errors = answer.body.find("errors");
  if (!errors || !errors->is_list()) {
    std::fprintf(stderr, "the server answers %d\n", answer.status);
    return;
  }
  for (const Value& error : errors->as_list())
    std::fprintf(stderr, "%s: %s: %s\n", text_of(error, "path").c_str(), text_of(error, "code").c_str(),
                 text_of(error, "message").c_str());
  if (answer.body.find("more_errors")) std::fprintf(stderr, "%s\n", kMoreErrors);
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

}  // namespace

Expected<std::string> token_of(const std::optional<std::string>& file) {
  if (file) return read_token_file(*file);
  return variable("RACE_TOKEN");
}

void ServerOptions::declare(Arguments& arguments, const std::string& json_help) {
  arguments.text("--server", "URL", url, "where the server is");
  arguments.text("--ca", "FILE", authority,
                 "of https alone, else refused: the authority of the server, tls/ca.pem of its data folder; else that "
                 "in RACE_CA, else those "
                 "that this machine trusts");
  arguments.text("--token-file", "FILE", token_file, "the token of your account; else that in RACE_TOKEN");
  arguments.flag("--json", json, json_help);
}

tl::expected<Value, int> ask_server(const ServerOptions& server, std::string_view method, const std::string& target,
                                    const std::optional<Value>& body) {
  auto client = HttpClient::create(server.url);
  if (!client) {
    const Error& error = client.error();
    return tl::unexpected(refuse(Error{error.code, error.message, "--server"}, server.json));
  }
  if (auto plain = refuse_authority(server)) return tl::unexpected(refuse(*plain, server.json));
  const auto token = token_of(server.token_file);
  if (!token) return tl::unexpected(refuse(token.error(), server.json));
  client->set_token(*token);
  client->set_authority(server.authority.value_or(variable("RACE_CA")));
  auto answer = client->request(method, target, body);
  if (!answer) return tl::unexpected(refuse(answer.error(), server.json));
  if (answer->status >= 200 && answer->status < 300) return std::move(answer->body);
  print_errors(*answer, server.json);
  return tl::unexpected(kExitFindings);
}

}  // namespace race::server
