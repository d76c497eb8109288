#include "server/http/client.h"

#include <boost/asio.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <memory>

#include "core/value/json.h"

namespace race::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
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

struct Subscription {
  std::string host, token, channel;
  const std::function<bool(const Value& message)>& take;
  HttpClient::Answer* refusal;
};

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

// What is done on a connection of its own, by one thread.
struct Exchange {
  static constexpr auto kAsTuple = asio::as_tuple(asio::use_awaitable);

  // With TLS if there is somebody to trust. `use` gets the stream, of either kind.
  template <typename Result, typename Use>
  asio::awaitable<Expected<Result>> run(const remote::Address& address, const Use& use, HttpClient::Timeouts timeouts,
                                        Trust* trust) {
    tcp::resolver resolver(io);
    const auto [unknown, endpoints] =
        co_await resolver.async_resolve(address.host, std::to_string(address.port), kAsTuple);
    if (unknown) co_return failure(unknown);
    if (is_stopped) co_return failure(asio::error::operation_aborted);  // connecting would open the stream again
    stream.expires_after(timeouts.connect);
    const auto [absent, endpoint] = co_await stream.async_connect(endpoints, kAsTuple);
    if (absent) co_return failure(absent);
    stream.expires_after(timeouts.answer);
    if (!trust) co_return co_await use(stream);
    secret.emplace(stream, *trust);
    error_code invalid;
    secret->set_verify_callback(asio::ssl::host_name_verification(address.host), invalid);
    if (invalid) co_return not_trusted(invalid);
    // RFC 6066, 3: names alone; what is no name is an address.
    asio::ip::make_address(address.host, invalid);
    if (invalid) SSL_set_tlsext_host_name(secret->native_handle(), address.host.c_str());
    const auto [distrust] = co_await secret->async_handshake(asio::ssl::stream_base::client, kAsTuple);
    if (distrust) co_return not_trusted(distrust);
    co_return co_await use(*secret);
  }

  template <typename Stream>
  static asio::awaitable<Expected<HttpClient::TextAnswer>> ask(Stream& stream, const ClientRequest& request) {
    const auto [unsent, sent] = co_await http::async_write(stream, request, kAsTuple);
    if (unsent) co_return failure(unsent);
    beast::flat_buffer buffer;
    http::response_parser<http::string_body> parser;
    parser.body_limit(HttpClient::kBodyBytes);
    const auto [broken, received] = co_await http::async_read(stream, buffer, parser, kAsTuple);
    if (broken) co_return failure(broken);
    co_return HttpClient::TextAnswer{static_cast<int>(parser.get().result_int()), std::move(parser.get().body())};
  }

  // The messages of a channel, as long as they are taken.
  template <typename Stream>
  static asio::awaitable<Expected<bool>> follow(Stream& stream, const Subscription& wanted) {
    websocket::stream<Stream&> socket(stream);
    socket.read_message_max(HttpClient::kBodyBytes);
    socket.set_option(websocket::stream_base::decorator([&wanted](websocket::request_type& request) {
      if (!wanted.token.empty()) request.set(http::field::authorization, "Bearer " + wanted.token);
    }));
    // Who is silent for half a minute, also for pings, is gone.
    socket.set_option(websocket::stream_base::timeout{std::chrono::seconds(10), std::chrono::seconds(30), true});
    websocket::response_type answer;
    const auto [refused] = co_await socket.async_handshake(answer, wanted.host, "/api/v1/stream", kAsTuple);
    if (refused && wanted.refusal) read_refusal(answer, *wanted.refusal);
    if (answer.result() == http::status::unauthorized || answer.result() == http::status::forbidden)
      co_return unexpected(ErrorCode::rights, "does not let in who asks");
    if (refused) co_return failure(refused);
    beast::get_lowest_layer(stream).expires_never();
    const std::string request = to_json(Dict{{"type", "subscribe"}, {"channel", wanted.channel}});
    const auto [unsent, sent] = co_await socket.async_write(asio::buffer(request), kAsTuple);
    if (unsent) co_return failure(unsent);
    for (beast::flat_buffer buffer;; buffer.clear()) {
      const auto [ended, received] = co_await socket.async_read(buffer, kAsTuple);
      if (ended) co_return failure(ended);
      const auto message = parse_json(beast::buffers_to_string(buffer.cdata()), {.depth = HttpClient::kBodyDepth});
      if (!message) co_return unexpected(ErrorCode::io, "sends what is no JSON");
      if (!wanted.take(*message)) co_return true;  // the connection ends with the command
    }
  }

  // Into `refusal`, if it is JSON.
  static void read_refusal(const websocket::response_type& answer, HttpClient::Answer& refusal) {
    const int status = static_cast<int>(answer.result_int());
    auto body = parse_json(answer.body());
    if (status >= 400 && body) refusal = {status, std::move(*body)};
  }

  // From any thread: whatever run() waits for ends, with an error.
  void stop_soon() {
    asio::post(io, [this] {
      is_stopped = true;
      stream.close();
    });
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
  bool is_stopped = false;
  std::optional<asio::ssl::stream<beast::tcp_stream&>> secret;  // what is under way when run() ends refers to it
};

}  // namespace

Expected<HttpClient> HttpClient::create(std::string url, Timeouts timeouts) {
  ASSIGN_OR_RETURN(remote::Address address, remote::read_address(url));
  return HttpClient(std::move(url), std::move(address), timeouts);
}

// `use` is called with the connected stream, and waited for.
template <typename Result, typename Use>
Expected<Result> HttpClient::connect_and(const Use& use, const std::stop_token& stop) const {
  std::unique_ptr<Trust> trust;
  if (address_.tls) {
    ASSIGN_OR_RETURN(trust, read_trust(authority_));
  }
  Exchange exchange;
  const std::stop_callback stopping(stop, [&exchange] { exchange.stop_soon(); });
  Expected<Result> outcome = unexpected(ErrorCode::unavailable, "the connection failed");
  asio::co_spawn(exchange.io, exchange.run<Result>(address_, use, timeouts_, trust.get()),
                 [&outcome](std::exception_ptr failed, Expected<Result> result) {
                   if (!failed) outcome = std::move(result);
                 });
  exchange.io.run();
  if (!outcome) return unexpected(outcome.error().code, outcome.error().message, url_);
  return outcome;
}

Expected<HttpClient::Answer> HttpClient::request(std::string_view method, std::string_view target,
                                                 const std::optional<Value>& body, const Headers& headers) const {
  ASSIGN_OR_RETURN(const TextAnswer answer, request_text(method, target, body, headers));
  auto read = parse_json(answer.body, {.depth = kBodyDepth});
  if (!read) return unexpected(ErrorCode::io, "answers " + std::to_string(answer.status) + " without JSON", url_);
  return Answer{answer.status, std::move(*read)};
}

Expected<HttpClient::TextAnswer> HttpClient::request_text(std::string_view method, std::string_view target,
                                                          const std::optional<Value>& body,
                                                          const Headers& headers) const {
  ClientRequest request = make_request(address_, token_, method, target, body);
  for (const auto& [name, value] : headers) request.set(name, value);
  return connect_and<TextAnswer>([&request](auto& stream) { return Exchange::ask(stream, request); });
}

Expected<void> HttpClient::follow(std::string_view channel, const std::function<bool(const Value& message)>& take,
                                  const FollowOptions& options) const {
  const Subscription wanted{address_.host + ':' + std::to_string(address_.port), token_, std::string(channel), take,
                            options.refusal};
  const auto done =
      connect_and<bool>([&wanted](auto& stream) { return Exchange::follow(stream, wanted); }, options.stop);
  if (!done && !options.stop.stop_requested()) return tl::unexpected(done.error());
  return {};
}

}  // namespace race::server
