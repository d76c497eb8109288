// The one file that knows Boost.Beast. Coroutines of one thread; the strands of the rest never block it.
#include "server/http/listener.h"

#include <array>
#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>

#include "core/value/json.h"
#include "server/http/door.h"
#include "server/http/errors.h"
#include "server/http/routes.h"
#include "server/http/static_files.h"
#include "server/stream/requests.h"

namespace race::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::awaitable;
using asio::ip::tcp;
using boost::system::error_code;
using namespace std::chrono_literals;

constexpr auto kUse = asio::as_tuple(asio::use_awaitable);
constexpr auto kDeparture = 30s;  // for an answer to leave
constexpr auto kLinger = 2s;      // for a client to stop sending what is refused
constexpr std::string_view kStream = "/api/v1/stream";
constexpr std::string_view kComponents = "/api/v1/components";

struct Context {
  Door door;
  std::string web;
  Application& app;
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

// What an answer to a request needs besides itself.
struct Manner {
  bool keep_alive = false;
  bool head = false;  // without the body
};

http::response<http::string_body> to_response(Reply reply, Manner manner) {
  http::response<http::string_body> response(static_cast<http::status>(reply.status), 11);
  response.keep_alive(manner.keep_alive);
  response.set(http::field::server, "race");
  response.set("X-Content-Type-Options", "nosniff");
  for (const auto& [name, value] : reply.headers) response.set(name, value);
  if (reply.type.empty()) {
    response.set(http::field::content_type, "application/json");
    if (response.find(http::field::cache_control) == response.end())
      response.set(http::field::cache_control, "no-store");
    response.body() = to_json(reply.body);
  } else {
    response.set(http::field::content_type, reply.type);
    response.body() = std::move(reply.text);
  }
  response.prepare_payload();
  if (manner.head) response.body().clear();
  return response;
}

Reply answer(Request request, Context& context) {
  if (request.path.starts_with("/api/")) return handle(std::move(request), context.app);
  if (request.method == "GET")
    if (auto file = static_file(context.web, request.path)) return std::move(*file);
  return refusal(404, "not_found", "there is no such page");
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

// One client of the stream. Held by its two coroutines, and by the hub until it leaves.
class StreamSession final : public Listener, public std::enable_shared_from_this<StreamSession> {
 public:
  StreamSession(beast::tcp_stream stream, Application& app)
      : socket_(std::move(stream)),
        waker_(socket_.get_executor()),
        executor_(socket_.get_executor()),
        hub_(app.hub()),
        displays_(app.displays()) {}

  Outbox& outbox() override { return outbox_; }
  void wake() override {
    asio::post(executor_, [self = shared_from_this()] { self->waker_.cancel(); });
  }

  awaitable<void> run(Parser::value_type request) {
    beast::get_lowest_layer(socket_).expires_never();
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_.read_message_max(Door::kMessageBytes);
    socket_.auto_fragment(false);  // a message is one frame
    const auto [failed] = co_await socket_.async_accept(request, kUse);
    if (failed) co_return;
    asio::co_spawn(
        executor_, [self = shared_from_this()] { return self->write(); }, asio::detached);
    beast::flat_buffer buffer(Door::kMessageBytes + 1024);
    for (;;) {
      const auto [error, bytes] = co_await socket_.async_read(buffer, kUse);
      if (error) break;
      if (!socket_.got_text()) break;
      const auto data = buffer.cdata();
      handle_stream_request({static_cast<const char*>(data.data()), data.size()}, shared_from_this(), hub_, displays_);
      buffer.consume(buffer.size());
    }
    over_ = true;
    displays_.leave(*this);
    hub_.leave(shared_from_this());
    waker_.cancel();
    beast::get_lowest_layer(socket_).close();
  }

 private:
  awaitable<void> write() {
    while (!over_) {
      while (auto text = outbox_.pop()) {
        const auto [error, bytes] = co_await socket_.async_write(asio::buffer(**text), kUse);
        if (error || over_) {
          beast::get_lowest_layer(socket_).close();
          co_return;
        }
      }
      for (const std::string& channel : outbox_.take_owed()) hub_.subscribe(shared_from_this(), channel, std::nullopt);
      waker_.expires_at(std::chrono::steady_clock::time_point::max());
      co_await waker_.async_wait(kUse);
    }
  }

  websocket::stream<beast::tcp_stream> socket_;
  asio::steady_timer waker_;
  asio::any_io_executor executor_;
  Hub& hub_;
  Displays& displays_;
  Outbox outbox_;
  bool over_ = false;
};

// One process of components. Held by its coroutines.
class ComponentSession final : public std::enable_shared_from_this<ComponentSession> {
 public:
  ComponentSession(beast::tcp_stream stream, remote::Remotes& remotes)
      : socket_(std::move(stream)),
        waker_(socket_.get_executor()),
        heart_(socket_.get_executor()),
        beat_(remotes.heartbeat() / remote::ProcessLink::kBeats),
        link_(remotes) {}

  awaitable<void> run(Parser::value_type request) {
    beast::get_lowest_layer(socket_).expires_never();
    socket_.read_message_max(remote::kFrameBytes);
    socket_.auto_fragment(false);
    const auto [failed] = co_await socket_.async_accept(request, kUse);
    if (failed) co_return;
    const auto executor = socket_.get_executor();
    asio::co_spawn(
        executor, [self = shared_from_this()] { return self->write(); }, asio::detached);
    asio::co_spawn(
        executor, [self = shared_from_this()] { return self->beat(); }, asio::detached);
    beast::flat_buffer buffer(remote::kFrameBytes + 1024);
    for (;;) {
      const auto [error, bytes] = co_await socket_.async_read(buffer, kUse);
      if (error) break;
      link_.received({beast::buffers_to_string(buffer.cdata()), socket_.got_binary()});
      buffer.consume(buffer.size());
    }
    over_ = true;
    link_.out().on_change({});
    link_.lose("its connection has ended");
    waker_.cancel();
    heart_.cancel();
  }

 private:
  awaitable<void> write() {
    link_.out().on_change([this, weak = weak_from_this(), executor = socket_.get_executor()] {
      asio::post(executor, [this, weak] {
        if (const auto self = weak.lock()) waker_.cancel();
      });
    });
    while (!over_) {
      while (auto frame = link_.out().pop()) {
        socket_.binary(frame->binary);
        const auto [error, bytes] = co_await socket_.async_write(asio::buffer(frame->bytes), kUse);
        if (error || over_) co_return close();
      }
      if (link_.out().drained()) co_return close();
      waker_.expires_at(std::chrono::steady_clock::time_point::max());
      co_await waker_.async_wait(kUse);
    }
  }

  awaitable<void> beat() {
    while (!over_) {
      heart_.expires_after(beat_);
      co_await heart_.async_wait(kUse);
      if (over_) co_return;
      link_.beat();
      if (link_.lost()) co_return close();
    }
  }

  void close() { beast::get_lowest_layer(socket_).close(); }

  websocket::stream<beast::tcp_stream> socket_;
  asio::steady_timer waker_, heart_;
  std::chrono::milliseconds beat_;
  remote::ProcessLink link_;
  bool over_ = false;
};

// Why a header could not be read.
std::optional<Reply> unreadable(error_code error) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow)
    return refusal(431, "too_large", "a header has at most " + std::to_string(Door::kHeaderBytes) + " bytes");
  if (error == http::error::body_limit)
    return refusal(413, "too_large", "a body has at most " + std::to_string(Door::kBodyBytes) + " bytes");
  if (error.category() == make_error_code(http::error::bad_method).category() && error != http::error::end_of_stream &&
      error != http::error::partial_message)
    return refusal(400, "http", error.message());
  return std::nullopt;  // the connection is gone
}

awaitable<bool> send(beast::tcp_stream& stream, Reply reply, Manner manner) {
  const auto response = to_response(std::move(reply), manner);
  stream.expires_after(kDeparture);
  const auto [error, bytes] = co_await http::async_write(stream, response, kUse);
  if (error || manner.keep_alive) co_return !error;
  // A client that is still sending would lose the answer if the connection were cut: what it sends is thrown away.
  error_code ignored;
  stream.socket().shutdown(tcp::socket::shutdown_send, ignored);
  stream.expires_after(kLinger);
  std::array<char, 65536> waste;
  for (std::size_t drained = 0; drained < 4 * Door::kBodyBytes;) {
    const auto [end, read] = co_await stream.async_read_some(asio::buffer(waste), kUse);
    if (end) break;
    drained += read;
  }
  co_return false;
}

// (An initializer list within a co_await expression is more than g++ 12 can do.)
Reply bad_target(const Error& error) {
  Reply reply = refusal(std::vector<Error>{error});
  reply.status = 400;
  return reply;
}

// One request of a connection, whose header may take `begin` to begin: whether another may follow.
awaitable<bool> serve_one(beast::tcp_stream& stream, beast::flat_buffer& buffer, Context& context,
                          std::chrono::milliseconds begin) {
  Parser parser;
  parser.header_limit(Door::kHeaderBytes);
  parser.body_limit(Door::kBodyBytes);
  if (buffer.size() == 0) {
    stream.expires_after(begin);
    const auto [error, bytes] = co_await stream.async_read_some(buffer.prepare(Door::kHeaderBytes), kUse);
    if (error) co_return false;
    buffer.commit(bytes);
  }
  stream.expires_after(context.limits.arrival);
  if (const auto [error, bytes] = co_await http::async_read_header(stream, buffer, parser, kUse); error) {
    if (auto reply = unreadable(error)) co_await send(stream, std::move(*reply), Manner());
    co_return false;
  }
  auto request = to_request(parser.get());
  if (!request) {
    Reply reply = bad_target(request.error());
    co_return co_await send(stream, std::move(reply), Manner());
  }
  const bool upgrade = websocket::is_upgrade(parser.get());
  Manner manner{false, request->method == "HEAD"};
  if (manner.head) request->method = "GET";
  if (auto refused = context.door.refuse(*request, upgrade))
    co_return co_await send(stream, std::move(*refused), manner);
  stream.expires_after(context.limits.arrival);
  if (const auto [error, bytes] = co_await http::async_read(stream, buffer, parser, kUse); error) {
    if (auto reply = unreadable(error)) co_await send(stream, std::move(*reply), Manner());
    co_return false;
  }
  if (upgrade && request->path == kStream && request->method == "GET") {
    auto session = std::make_shared<StreamSession>(std::move(stream), context.app);
    co_await session->run(parser.release());
    co_return false;
  }
  if (upgrade && request->path == kComponents && request->method == "GET") {
    auto session = std::make_shared<ComponentSession>(std::move(stream), context.app.cell().remotes());
    co_await session->run(parser.release());
    co_return false;
  }
  if (request->path == kStream || request->path == kComponents) {
    Reply reply = refusal(426, "upgrade", "a WebSocket is served here");
    co_return co_await send(stream, std::move(reply), Manner());
  }
  manner.keep_alive = parser.keep_alive();
  request->body = std::move(parser.get().body());
  stream.expires_never();
  std::function<Reply()> work = [request = std::move(*request), &context] { return answer(request, context); };
  Reply reply = co_await on_pool(context.handlers, std::move(work));
  co_return co_await send(stream, std::move(reply), manner);
}

awaitable<void> serve(tcp::socket socket, Context& context) {
  beast::tcp_stream stream(std::move(socket));
  beast::flat_buffer buffer(Door::kHeaderBytes + 64 * 1024);
  try {
    bool more = co_await serve_one(stream, buffer, context, context.limits.arrival);
    while (more) more = co_await serve_one(stream, buffer, context, context.limits.idle);
  } catch (const std::exception& failure) {
    context.app.log("server", std::string("a connection failed: ") + failure.what());
  }
  --context.connections;
}

awaitable<void> accept(tcp::acceptor& acceptor, Context& context) {
  for (;;) {
    auto [error, socket] = co_await acceptor.async_accept(kUse);
    if (error == asio::error::operation_aborted) co_return;
    if (error) {  // out of descriptors: others will be given back
      asio::steady_timer pause(acceptor.get_executor(), 100ms);
      co_await pause.async_wait(kUse);
      continue;
    }
    if (context.connections >= context.limits.connections) continue;
    ++context.connections;
    error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    asio::co_spawn(acceptor.get_executor(), serve(std::move(socket), context), asio::detached);
  }
}

}  // namespace

struct HttpServer::Sockets {
  Sockets(std::string its_web, Application& app, const Limits& limits)
      : acceptor(io),
        handlers(std::make_unique<Pool>(4)),
        context{Door(0), std::move(its_web), app, *handlers, limits} {}
  // Handlers end, and the hub lets go of its listeners, while the sockets are still there.
  ~Sockets() {
    handlers.reset();
    context.app.hub().release();
  }

  asio::io_context io{1};
  tcp::acceptor acceptor;
  std::unique_ptr<Pool> handlers;
  Context context;
};

HttpServer::HttpServer(std::unique_ptr<Sockets> sockets) : sockets_(std::move(sockets)) {}
HttpServer::~HttpServer() = default;

Expected<std::unique_ptr<HttpServer>> HttpServer::listen(std::uint16_t port, std::string web, Application& app,
                                                         const Limits& limits) {
  auto sockets = std::make_unique<Sockets>(std::move(web), app, limits);
  const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), port);
  try {
    sockets->acceptor.open(endpoint.protocol());
    sockets->acceptor.set_option(tcp::acceptor::reuse_address(true));
    sockets->acceptor.bind(endpoint);
    sockets->acceptor.listen();
  } catch (const boost::system::system_error& failure) {
    return unexpected(ErrorCode::io, failure.code().message(), "127.0.0.1:" + std::to_string(port));
  }
  sockets->context.door = Door(sockets->acceptor.local_endpoint().port());
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(sockets)));
}

std::uint16_t HttpServer::port() const { return sockets_->acceptor.local_endpoint().port(); }

void HttpServer::run() {
  asio::signal_set signals(sockets_->io, SIGINT, SIGTERM);
  signals.async_wait([this](error_code, int) { sockets_->io.stop(); });
  asio::co_spawn(sockets_->io, accept(sockets_->acceptor, sockets_->context), asio::detached);
  sockets_->io.run();
}

void HttpServer::stop() { sockets_->io.stop(); }

}  // namespace race::server
