#include "api/cpp/client/client.h"

#include <algorithm>
#include <utility>

#include "api/cpp/client/calls.h"
#include "core/value/json.h"
#include "services/remote/address.h"

namespace race::client {
namespace {

using server::HttpClient;

bool is_one_of(char c, std::string_view others) { return others.find(c) != std::string_view::npos; }

// RFC 6750: letters, digits and -._~+/, then =.
bool is_token(std::string_view text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || is_one_of(c, "-._~+/=");
  };
  return std::all_of(text.begin(), text.end(), fits);
}

bool is_own_machine(std::string_view host) {
  const bool is_loopback = host.starts_with("127.") && host.find_first_not_of("0123456789.") == std::string_view::npos;
  return is_loopback || host == "localhost" || host.ends_with(".localhost");
}

// Nothing in it ends the header (RFC 9110, 5.5).
bool is_header(std::string_view text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; });
}

// Whether it can be sent.
bool is_sound(const Call& call) {
  const bool is_finite = !call.body || call.body->is_finite();
  return is_finite && std::all_of(call.headers.begin(), call.headers.end(),
                                  [](const auto& header) { return is_header(header.second); });
}

// What an answer says; the errors of one that refuses.
Answered<Value> read(const Call& call, HttpClient::TextAnswer answer) {
  if (answer.status == 304)
    return tl::unexpected(refusal(
        304, Dict{{"errors",
                   List{Dict{{"path", ""}, {"code", "not_modified"}, {"message", "the client has this revision"}}}}}));
  const bool is_fine = answer.status >= 200 && answer.status < 300;
  if (is_fine && call.is_text) return Value(std::move(answer.body));
  const auto body = parse_json(answer.body, {.depth = HttpClient::kBodyDepth});
  if (!is_fine) return tl::unexpected(refusal(answer.status, body ? *body : Value()));
  if (!body || !body->is_dict())
    return failure(kProtocol, call.target + " is not answered with a JSON object: not a server of RACE?", true);
  return *body;
}

}  // namespace

Answered<Client> Client::create(std::string url, const ClientOptions& options) {
  const auto address = remote::read_address(url);
  if (!address) return failure(kArgument, address.error().message);
  if (!address->tls && !is_own_machine(address->host))
    return failure(kArgument, quote(url) + ": another machine is reached by https alone");
  if (!is_token(options.token)) return failure(kArgument, "the token has characters that no token has");
  const HttpClient::Timeouts timeouts{.connect = std::min(options.timeout, HttpClient::Timeouts().connect),
                                      .answer = options.timeout};
  auto http = HttpClient::create(std::move(url), timeouts);
  if (!http) return failure(kArgument, http.error().message);
  http->set_token(options.token);
  http->set_authority(options.authority);
  return Client(std::move(*http), options.timeout);
}

Answered<Value> Client::send(const Call& call) const {
  if (!is_sound(call))
    return failure(kArgument, call.target + ": a number is not finite, or a header has a control character");
  auto answer = http_.request_text(call.method, call.target, call.body, call.headers);
  if (!answer) return tl::unexpected(connection_error(answer.error()));
  return read(call, std::move(*answer));
}

Answered<Value> Client::log_in(std::string_view name, std::string_view password) {
  auto answer = send(calls::log_in(Dict{{"name", name}, {"password", password}}));
  if (!answer) return answer;
  const Value* const token = answer->find("token");
  if (!token || !token->is_string() || !is_token(token->as_string()))
    return failure(kProtocol, "the login is answered without a token", true);
  http_.set_token(token->as_string());
  return answer;
}

Answered<Value> Client::log_out() {
  auto answer = send(calls::log_out());
  if (answer) http_.set_token("");
  return answer;
}

Answered<Following> Client::follow(std::string_view core, std::chrono::milliseconds within) const {
  return Following::open(http_, core, within);
}

}  // namespace race::client
