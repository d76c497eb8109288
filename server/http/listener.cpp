// The sockets. Coroutines of one thread; the strands of the rest never block it.
#include "server/http/listener.h"

#include <chrono>

#include "server/http/serving.h"
#include "services/failures.h"
#include "services/time_slice.h"

namespace race::server {
namespace {

using asio::ip::tcp;
using namespace std::chrono_literals;

constexpr auto kEndTimeout = 500ms;  // for what is under way when the server ends

void admit(tcp::socket socket, Context& context) {
  error_code gone;
  const tcp::endpoint address = socket.remote_endpoint(gone);
  if (gone) return;
  socket.set_option(tcp::no_delay(true), gone);
  const asio::any_io_executor executor = socket.get_executor();
  auto client = std::make_unique<Client>(std::move(socket), address.address().to_string());
  client->place = context.connections.admit(client->address, [raw = client.get()] { raw->stream.close(); });
  if (!client->place) return;
  asio::co_spawn(executor, serve(std::move(client), context), asio::detached);
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
      : connections(limits.connections),
        budget(limits.held_bytes),
        acceptor(io),
        handlers(std::make_unique<Pool>(4, 0, "requests")),
        urgent(std::make_unique<Pool>(1, 0, "urgent")),
        context{RequestFilter(0),
                std::move(its_web),
                std::move(backend),
                *handlers,
                *urgent,
                std::make_shared<ReplyPath>(io),
                connections,
                budget,
                limits,
                io} {}
  // Handlers end, and the hub drops its subscribers, while the sockets are still there. Whose request no handler has
  // begun gets no answer; what is answered later is not sent.
  ~Sockets() {
    context.replies->close();
    handlers->drop();
    handlers.reset();
    urgent->drop();
    urgent.reset();
    context.backend.hub.shut_down();
  }
  // Nothing begins any more. Who still answers or says something may end.
  void end() {
    if (std::exchange(context.ending, true)) return;
    error_code ignored;
    acceptor.close(ignored);
    connections.end_all();
    if (connections.empty()) return io.stop();
    end_timer.expires_after(kEndTimeout);
    end_timer.async_wait([this](error_code) { io.stop(); });
  }

  Connections connections;  // they outlive the coroutines, which end with `io`
  ByteBudget budget;
  asio::io_context io{1};
  asio::signal_set signals{io, SIGINT, SIGTERM};  // from here on: one that comes before run() ends it, too
  asio::steady_timer end_timer{io};
  tcp::acceptor acceptor;
  std::uint16_t port = 0;
  std::unique_ptr<Pool> handlers, urgent;
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
  sockets->port = sockets->acceptor.local_endpoint().port();
  sockets->context.filter = RequestFilter(sockets->port);
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(sockets)));
}

std::uint16_t HttpServer::port() const { return sockets_->port; }

void HttpServer::run() {
  services::shorten_time_slice();
  sockets_->context.urgent.post(services::shorten_time_slice);
  sockets_->signals.async_wait([this](error_code, int) { sockets_->end(); });
  asio::co_spawn(sockets_->io, accept(sockets_->acceptor, sockets_->context), asio::detached);
  // What throws there has ended a handler; the others go on.
  while (!services::run_reporting("the sockets", [this] { sockets_->io.run(); })) continue;
}

void HttpServer::stop() {
  asio::post(sockets_->io, [this] { sockets_->end(); });
}

}  // namespace race::server
