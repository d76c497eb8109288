#include "server/http/client.h"

#include <boost/asio.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <memory>

#include "core/value/json.h"

namespace race::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using boost::system::error_code;

using ClientRequest = http::request<http::string_body>;

ClientRequest make_request(const remote::Address& address, const std::string& token, std::string_view method,
                           std::string_view target, const std::optional<Value>& body) {
  ClientRequest request(http::string_to_verb(method), target, 11);
  request.set(http::field::host, address.host + ":" + std::to_string(address.port));
  request.set(http::field::accept, "application/json");
  if (!token.empty()) request.set(http::field::authorization, "Bearer " + token);
  request.keep_alive(false);
  if (body) {
    request.set(http::field::content_type, "application/json");
    request.body() = to_json(*body);
  }
  request.prepare_payload();
  return request;
}

using Trust = asio::ssl::context;

// Of an authority (PEM), or without one, of those that the machine trusts. Error `io`.
Expected<std::unique_ptr<Trust>> read_trust(const std::string& authority) {
  auto trust = std::make_unique<Trust>(Trust::tls_client);
  error_code failed;
  trust->set_options(Trust::default_workarounds | Trust::no_tlsv1 | Trust::no_tlsv1_1, failed);
  if (!failed) trust->set_verify_mode(asio::ssl::verify_peer, failed);
  if (!failed && authority.empty()) trust->set_default_verify_paths(failed);
  if (!failed && !authority.empty()) trust->load_verify_file(authority, failed);
  if (failed) return unexpected(ErrorCode::io, "no certificate can be read: " + failed.message(), authority);
  return trust;
}

// One request on a connection of its own.
struct Exchange {
  static constexpr auto kAsTuple = asio::as_tuple(asio::use_awaitable);

  // With TLS if there is somebody to trust.
  asio::awaitable<Expected<HttpClient::Answer>> run(const remote::Address& address, const ClientRequest& request,
                                                    HttpClient::Timeouts timeouts, Trust* trust) {
    tcp::resolver resolver(io);
    const auto [unknown, endpoints] =
        co_await resolver.async_resolve(address.host, std::to_string(address.port), kAsTuple);
    if (unknown) co_return failure(unknown);
    stream.expires_after(timeouts.connect);
    const auto [absent, endpoint] = co_await stream.async_connect(endpoints, kAsTuple);
    if (absent) co_return failure(absent);
    stream.expires_after(timeouts.answer);
    if (!trust) co_return co_await ask(stream, request);
    asio::ssl::stream<beast::tcp_stream&> secret(stream, *trust);
    error_code invalid;
    secret.set_verify_callback(asio::ssl::host_name_verification(address.host), invalid);
    if (invalid) co_return not_trusted(invalid);
    // RFC 6066, 3: names alone; what is no name is an address.
    asio::ip::make_address(address.host, invalid);
    if (invalid) SSL_set_tlsext_host_name(secret.native_handle(), address.host.c_str());
    const auto [distrust] = co_await secret.async_handshake(asio::ssl::stream_base::client, kAsTuple);
    if (distrust) co_return not_trusted(distrust);
    co_return co_await ask(secret, request);
  }

  template <typename Stream>
  static asio::awaitable<Expected<HttpClient::Answer>> ask(Stream& stream, const ClientRequest& request) {
    const auto [unsent, sent] = co_await http::async_write(stream, request, kAsTuple);
    if (unsent) co_return failure(unsent);
    beast::flat_buffer buffer;
    http::response_parser<http::string_body> parser;
    parser.body_limit(HttpClient::kBodyBytes);
    const auto [broken, received] = co_await http::async_read(stream, buffer, parser, kAsTuple);
    if (broken) co_return failure(broken);
    auto body = parse_json(parser.get().body());
    if (!body)
      co_return unexpected(ErrorCode::io, "answers " + std::to_string(parser.get().result_int()) + " without JSON");
    co_return HttpClient::Answer{static_cast<int>(parser.get().result_int()), std::move(*body)};
  }

  // Of the network; or of what is there, if it speaks no HTTP.
  static tl::unexpected<Error> failure(error_code error) {
    const bool is_http = error.category() == make_error_code(http::error::bad_method).category();
    const bool ended = error == http::error::end_of_stream || error == http::error::partial_message;
    return unexpected(is_http && !ended ? ErrorCode::io : ErrorCode::unavailable, error.message());
  }

  static tl::unexpected<Error> not_trusted(error_code error) {
    if (error.category() != asio::error::get_ssl_category()) return failure(error);
    return unexpected(ErrorCode::io, "is not trusted, or speaks no TLS: " + error.message());
  }

  asio::io_context io{1};
  beast::tcp_stream stream{io};
};

}  // namespace

Expected<HttpClient> HttpClient::create(std::string url, Timeouts timeouts) {
  ASSIGN_OR_RETURN(remote::Address address, remote::read_address(url));
  return HttpClient(std::move(url), std::move(address), timeouts);
}

Expected<HttpClient::Answer> HttpClient::request(std::string_view method, std::string_view target,
                                                 const std::optional<Value>& body, const Headers& headers) const {
  ClientRequest request = make_request(address_, token_, method, target, body);
  for (const auto& [name, value] : headers) request.set(name, value);
  std::unique_ptr<Trust> trust;
  if (address_.tls) {
    ASSIGN_OR_RETURN(trust, read_trust(authority_));
  }
  Exchange exchange;
  Expected<Answer> answer = unexpected(ErrorCode::unavailable, "the connection failed");
  asio::co_spawn(exchange.io, exchange.run(address_, request, timeouts_, trust.get()),
                 [&answer](std::exception_ptr failed, Expected<Answer> result) {
                   if (!failed) answer = std::move(result);
                 });
  exchange.io.run();
  if (!answer) return unexpected(answer.error().code, answer.error().message, url_);
  return answer;
}

}  // namespace race::server
