#include "server/http/response.h"

#include <array>
#include <new>
#include <utility>

#include "core/value/json.h"
#include "server/http/refusal.h"
#include "server/http/request_filter.h"
#include "services/failures.h"

namespace race::server {
namespace {

constexpr std::chrono::seconds kDrainTimeout{2};

// Problem details (RFC 9457) of a refusal. They have no type of their own: `errors` have the codes.
Value problem(int status, const Value& refused) {
  const Value& errors = *refused.find("errors");
  Dict json{{"status", status},
            {"title", std::string(http::obsolete_reason(static_cast<http::status>(status)))},
            {"detail", *errors.as_list().front().find("message")}};
  for (const auto& [key, value] : refused.as_dict()) json.set(key, value);  // schemas/errors.json
  return json;
}

// What a browser may do with an answer of ours (http/README.md). Pages use scripts, styles, fonts and workers of their
// own, images that displays get as data, and nothing of other servers. A foreign page that shows ours in a frame could
// have its visitors press our buttons.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kPageRules = {{
    {"Content-Security-Policy",
     "default-src 'self'; img-src 'self' data:; object-src 'none'; base-uri 'none'; form-action 'none'; "
     "frame-ancestors 'none'"},
    {"X-Frame-Options", "DENY"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Referrer-Policy", "same-origin"},
}};

Response to_response(Reply reply, ResponseOptions options) {
  Response response(static_cast<http::status>(reply.status), 11);
  response.keep_alive(options.keep_alive);
  response.set(http::field::server, "race");
  response.set("X-Content-Type-Options", "nosniff");
  for (const auto& [name, value] : kPageRules) response.set(name, value);
  if (!options.connect_sources.empty())
    response.set("Content-Security-Policy",
                 std::string(kPageRules[0].second) + "; connect-src 'self'" + std::string(options.connect_sources));
  for (const auto& [name, value] : reply.headers) response.set(name, value);
  if (reply.type.empty()) {
    const bool is_refusal = reply.status >= 400;
    response.set(http::field::content_type, is_refusal ? "application/problem+json" : "application/json");
    if (response.find(http::field::cache_control) == response.end())
      response.set(http::field::cache_control, "no-store");
    response.body() = to_json(is_refusal ? problem(reply.status, reply.body) : reply.body);
  } else {
    response.set(http::field::content_type, reply.type);
    response.body() = std::move(reply.text);
  }
  if (reply.status == 304) {  // has no content, and no headers of one
    response.body().clear();
    response.erase(http::field::content_type);
  }
  response.prepare_payload();
  if (reply.status == 304) response.erase(http::field::content_length);  // it would have to be that of the file
  if (options.head) response.body().clear();
  return response;
}

}  // namespace

Response make_response(Reply reply, ResponseOptions options) {
  try {
    return to_response(std::move(reply), options);
  } catch (const std::bad_alloc&) {
    services::report_failure("a response");
    return to_response(no_memory(), options);
  }
}

Reply overload(const std::string& message) {
  Reply reply = refusal(503, "overload", message);
  reply.headers.emplace_back("Retry-After", "1");
  return reply;
}

Reply no_memory() { return refusal(503, "out_of_memory", "the server has no memory left for this"); }

awaitable<bool> send(NetStream& stream, Response response, std::chrono::milliseconds timeout) {
  const bool keep_alive = response.keep_alive();
  error_code ignored;
  // Until it has left, closing drops it: the kernel keeps nothing for who does not take it.
  stream.socket().set_option(asio::socket_base::linger(true, 0), ignored);
  http::response_serializer<http::string_body> serializer(response);
  stream.expires_after(timeout);
  for (std::size_t taken = 0; !serializer.is_done();) {
    const auto [error, bytes] = co_await http::async_write_some(stream, serializer, kAsTuple);
    if (error) co_return false;
    taken += bytes;
    if (taken < kResponsePiece) continue;
    taken = 0;
    stream.expires_after(timeout);
  }
  stream.socket().set_option(asio::socket_base::linger(false, 0), ignored);
  co_return keep_alive;
}

awaitable<void> drain(NetStream& stream) {
  error_code ignored;
  stream.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  stream.expires_after(kDrainTimeout);
  std::array<char, 16 * 1024> waste;
  for (std::size_t drained = 0; drained < 4 * RequestFilter::kBodyBytes;) {
    const auto [end, read] = co_await stream.async_read_some(asio::buffer(waste), kAsTuple);
    if (end) break;
    drained += read;
  }
}

}  // namespace race::server
