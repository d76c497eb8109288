// The sockets. Coroutines of one thread; the strands of the rest never block it.
#include "server/http/listener.h"

#include <array>
#include <chrono>
#include <new>

#include "core/value/json.h"
#include "server/http/refusal.h"
#include "server/http/request_filter.h"
#include "server/http/sessions.h"
#include "server/http/static_files.h"
#include "services/failures.h"

namespace race::server {
namespace {

using asio::ip::tcp;
using boost::system::error_code;
using namespace std::chrono_literals;

constexpr auto kWriteTimeout = 30s;  // of a response
constexpr auto kDrainTimeout = 2s;   // for a client to stop sending what is refused
constexpr std::string_view kStream = "/api/v1/stream";
constexpr std::string_view kComponents = "/api/v1/components";

struct Context {
  RequestFilter filter;
  std::string web;
  Backend backend;
  Pool& handlers;
  HttpServer::Limits limits;
  int connections = 0;
};

using Parser = http::request_parser<http::string_body>;

// Beast's request as ours. Error: the target.
Expected<Request> to_request(const http::request<http::string_body>& from) {
  Request request;
  request.method = std::string(from.method_string());
  for (const auto& field : from) {
    std::string name(field.name_string());
    for (char& c : name) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
    request.headers.emplace_back(std::move(name), std::string(field.value()));
  }
  ASSIGN_OR_RETURN(auto target, parse_target(std::string_view(from.target())));
  request.path = std::move(target.first);
  request.query = std::move(target.second);
  return request;
}

struct ResponseOptions {
  bool keep_alive = false;
  bool head = false;  // without the body
};

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

http::response<http::string_body> to_response(Reply reply, ResponseOptions options) {
  http::response<http::string_body> response(static_cast<http::status>(reply.status), 11);
  response.keep_alive(options.keep_alive);
  response.set(http::field::server, "race");
  response.set("X-Content-Type-Options", "nosniff");
  for (const auto& [name, value] : kPageRules) response.set(name, value);
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

Reply find_answer(Request request, Context& context) {
  if (request.path.starts_with("/api/")) return context.backend.handle(std::move(request));
  if (request.method == "GET")
    if (auto file = static_file(context.web, request)) return std::move(*file);
  return refusal(404, "not_found", "there is no such page");
}

Reply no_memory() { return refusal(503, "out_of_memory", "the server has no memory left for this"); }

// An exception ends its request alone.
Reply answer(Request request, Context& context) {
  const std::string name = request.method + ' ' + request.path;
  try {
    return find_answer(std::move(request), context);
  } catch (const std::bad_alloc&) {
    services::report_failure(name.c_str());
    return no_memory();
  } catch (...) {
    services::report_failure(name.c_str());
    return refusal(500, "internal", "the server failed to answer; see its log");
  }
}

// Runs `work` on the pool of the handlers and goes on here with its value. (What a co_await expression uses has a name:
// g++ 12 destroys temporaries with captures twice.)
awaitable<Reply> on_pool(Pool& pool, std::function<Reply()> work) {
  const asio::any_io_executor executor = co_await asio::this_coro::executor;
  auto initiate = [&pool, &executor, &work](auto handler) {
    // Held by the work until its value is handed over.
    auto shared = std::make_shared<decltype(handler)>(std::move(handler));
    pool.post([shared, executor, work = std::move(work)]() mutable {
      auto reply = std::make_shared<Reply>(work());
      asio::post(executor, [shared = std::move(shared), reply] { (*shared)(std::move(*reply)); });
    });
  };
  Reply reply =
      co_await asio::async_initiate<const asio::use_awaitable_t<>, void(Reply)>(initiate, asio::use_awaitable);
  co_return reply;
}

// The response to a request that could not be read; nothing: the connection is gone.
std::optional<Reply> read_error(error_code error) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow)
    return refusal(431, "too_large", "a header has at most " + std::to_string(RequestFilter::kHeaderBytes) + " bytes");
  if (error == http::error::body_limit)
    return refusal(413, "too_large", "a body has at most " + std::to_string(RequestFilter::kRunFileBytes) + " bytes");
  if (error.category() == make_error_code(http::error::bad_method).category() && error != http::error::end_of_stream &&
      error != http::error::partial_message)
    return refusal(400, "http", error.message());
  return std::nullopt;
}

// The response, or that there is no memory for it.
http::response<http::string_body> try_response(Reply reply, ResponseOptions options) {
  try {
    return to_response(std::move(reply), options);
  } catch (const std::bad_alloc&) {
    services::report_failure("a response");
    return to_response(no_memory(), options);
  }
}

awaitable<bool> send(beast::tcp_stream& stream, Reply reply, ResponseOptions options) {
  const auto response = try_response(std::move(reply), options);
  stream.expires_after(kWriteTimeout);
  const auto [error, bytes] = co_await http::async_write(stream, response, kAsTuple);
  if (error || options.keep_alive) co_return !error;
  // Closing while the client still sends would reset the connection before it has read the response: drain first.
  error_code ignored;
  stream.socket().shutdown(tcp::socket::shutdown_send, ignored);
  stream.expires_after(kDrainTimeout);
  std::array<char, 65536> waste;
  for (std::size_t drained = 0; drained < 4 * RequestFilter::kBodyBytes;) {
    const auto [end, read] = co_await stream.async_read_some(asio::buffer(waste), kAsTuple);
    if (end) break;
    drained += read;
  }
  co_return false;
}

// (An initializer list within a co_await expression is more than g++ 12 can do.)
Reply bad_target(const Error& error) { return refusal(400, std::vector<Error>{error}); }
Reply no_upgrade() {
  Reply reply = refusal(426, "upgrade", "a WebSocket is served here");
  reply.headers.emplace_back("Upgrade", "websocket");
  return reply;
}

// Serves one request of a connection; its first byte may take `begin`. Returns whether another may follow.
awaitable<bool> serve_one(beast::tcp_stream& stream, beast::flat_buffer& buffer, Context& context,
                          std::chrono::milliseconds begin) {
  Parser parser;
  parser.header_limit(RequestFilter::kHeaderBytes);
  parser.body_limit(RequestFilter::kRunFileBytes);  // of most routes it is less: the filter refuses by Content-Length
  if (buffer.size() == 0) {
    stream.expires_after(begin);
    const auto [error, bytes] = co_await stream.async_read_some(buffer.prepare(RequestFilter::kHeaderBytes), kAsTuple);
    if (error) co_return false;
    buffer.commit(bytes);
  }
  stream.expires_after(context.limits.read_timeout);
  if (const auto [error, bytes] = co_await http::async_read_header(stream, buffer, parser, kAsTuple); error) {
    if (auto reply = read_error(error)) co_await send(stream, std::move(*reply), ResponseOptions());
    co_return false;
  }
  auto request = to_request(parser.get());
  if (!request) {
    Reply reply = bad_target(request.error());
    co_return co_await send(stream, std::move(reply), ResponseOptions());
  }
  const bool upgrade = websocket::is_upgrade(parser.get());
  ResponseOptions options{false, request->method == "HEAD"};
  if (options.head) request->method = "GET";
  if (auto refused = context.filter.refuse(*request, upgrade))
    co_return co_await send(stream, std::move(*refused), options);
  stream.expires_after(context.limits.read_timeout);
  if (const auto [error, bytes] = co_await http::async_read(stream, buffer, parser, kAsTuple); error) {
    if (auto reply = read_error(error)) co_await send(stream, std::move(*reply), ResponseOptions());
    co_return false;
  }
  if (upgrade && request->path == kStream && request->method == "GET") {
    const StreamTargets targets{context.backend.hub, context.backend.displays, context.backend.edits};
    co_await serve_stream(std::move(stream), parser.release(), targets);
    co_return false;
  }
  if (upgrade && request->path == kComponents && request->method == "GET") {
    co_await serve_components(std::move(stream), parser.release(), context.backend.remotes, context.backend.hub);
    co_return false;
  }
  if (request->path == kStream || request->path == kComponents) {
    Reply reply = no_upgrade();
    co_return co_await send(stream, std::move(reply), ResponseOptions());
  }
  options.keep_alive = parser.keep_alive();
  request->body = std::move(parser.get().body());
  stream.expires_never();
  std::function<Reply()> work = [request = std::move(*request), &context] { return answer(request, context); };
  Reply reply = co_await on_pool(context.handlers, std::move(work));
  co_return co_await send(stream, std::move(reply), options);
}

awaitable<void> serve(tcp::socket socket, Context& context) {
  try {
    beast::tcp_stream stream(std::move(socket));
    beast::flat_buffer buffer(RequestFilter::kHeaderBytes + 64 * 1024);
    bool more = co_await serve_one(stream, buffer, context, context.limits.read_timeout);
    while (more) more = co_await serve_one(stream, buffer, context, context.limits.idle_timeout);
  } catch (...) {
    services::report_failure("a connection");
  }
  --context.connections;
}

void admit(tcp::socket socket, Context& context) {
  if (context.connections >= context.limits.connections) return;
  error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  const asio::any_io_executor executor = socket.get_executor();
  asio::co_spawn(executor, serve(std::move(socket), context), asio::detached);
  ++context.connections;
}

// Until the acceptor is closed. Whoever it cannot serve, it goes on.
awaitable<void> accept(tcp::acceptor& acceptor, Context& context) {
  while (acceptor.is_open()) {
    bool failed = false;
    try {
      auto [error, socket] = co_await acceptor.async_accept(kAsTuple);
      failed = static_cast<bool>(error);
      if (!failed) admit(std::move(socket), context);
    } catch (...) {
      services::report_failure("a new connection");
      failed = true;
    }
    if (!failed || !acceptor.is_open()) continue;
    asio::steady_timer pause(acceptor.get_executor(), 100ms);  // out of descriptors or memory: it will be given back
    co_await pause.async_wait(kAsTuple);
  }
}

}  // namespace

struct HttpServer::Sockets {
  Sockets(std::string its_web, Backend backend, const Limits& limits)
      : acceptor(io),
        handlers(std::make_unique<Pool>(4)),
        context{RequestFilter(0), std::move(its_web), std::move(backend), *handlers, limits} {}
  // Handlers end, and the hub drops its subscribers, while the sockets are still there.
  ~Sockets() {
    handlers.reset();
    context.backend.hub.shut_down();
  }

  asio::io_context io{1};
  asio::signal_set signals{io, SIGINT, SIGTERM};  // from here on: one that comes before run() ends it, too
  tcp::acceptor acceptor;
  std::unique_ptr<Pool> handlers;
  Context context;
};

HttpServer::HttpServer(std::unique_ptr<Sockets> sockets) : sockets_(std::move(sockets)) {}
HttpServer::~HttpServer() = default;

Expected<std::unique_ptr<HttpServer>> HttpServer::listen(std::uint16_t port, std::string web, Backend backend,
                                                         const Limits& limits) {
  auto sockets = std::make_unique<Sockets>(std::move(web), std::move(backend), limits);
  const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), port);
  try {
    sockets->acceptor.open(endpoint.protocol());
    sockets->acceptor.set_option(tcp::acceptor::reuse_address(true));
    sockets->acceptor.bind(endpoint);
    sockets->acceptor.listen();
  } catch (const boost::system::system_error& failure) {
    return unexpected(ErrorCode::io, failure.code().message(), "127.0.0.1:" + std::to_string(port));
  }
  sockets->context.filter = RequestFilter(sockets->acceptor.local_endpoint().port());
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(sockets)));
}

std::uint16_t HttpServer::port() const { return sockets_->acceptor.local_endpoint().port(); }

void HttpServer::run() {
  sockets_->signals.async_wait([this](error_code, int) { sockets_->io.stop(); });
  asio::co_spawn(sockets_->io, accept(sockets_->acceptor, sockets_->context), asio::detached);
  // What throws there has ended a handler; the others go on.
  while (!services::run_reporting("the sockets", [this] { sockets_->io.run(); })) continue;
}

void HttpServer::stop() { sockets_->io.stop(); }

}  // namespace race::server
