// The sockets. Coroutines of one thread; the strands of the rest never block it.
#include "server/http/listener.h"

#include <boost/asio/ssl.hpp>
#include <chrono>

#include "server/http/listening.h"
#include "server/http/serving.h"
#include "server/http/stop_server.h"
#include "services/failures.h"
#include "services/time_slice.h"

namespace race::server {
namespace {

using asio::ip::tcp;
using namespace std::chrono_literals;

constexpr auto kLastWords = 50ms;    // for what clients are told of the end to reach them
constexpr auto kEndTimeout = 500ms;  // for what is under way when the server ends
// Of a connection [bytes], of which the kernel keeps twice as much for what a client has not taken yet; by itself, it
// would go to 4 MiB, which are no part of any limit here, and make what a slow client sees old.
constexpr int kSendBuffer = 256 * 1024;

// TLS 1.2 and later with the ciphers of OpenSSL's default, without renegotiation and compression. Empty: the
// certificate is none, or not of the key.
std::shared_ptr<asio::ssl::context> make_tls(const std::string& chain, const std::string& key) {
  auto tls = std::make_shared<asio::ssl::context>(asio::ssl::context::tls_server);
  error_code failed;
  tls->set_options(asio::ssl::context::default_workarounds | asio::ssl::context::no_tlsv1 |
                       asio::ssl::context::no_tlsv1_1 | asio::ssl::context::no_compression,
                   failed);
  SSL_CTX_set_options(tls->native_handle(), SSL_OP_NO_RENEGOTIATION);
  SSL_CTX_set_mode(tls->native_handle(), SSL_MODE_RELEASE_BUFFERS);  // of connections that are idle
  if (!failed) tls->use_certificate_chain(asio::buffer(chain), failed);
  if (!failed) tls->use_private_key(asio::buffer(key), asio::ssl::context::pem, failed);
  if (failed || SSL_CTX_check_private_key(tls->native_handle()) != 1) return nullptr;
  return tls;
}

NetStream stream_of(tcp::socket socket, const Endpoint& endpoint) {
  return endpoint.tls ? NetStream(std::move(socket), *endpoint.tls) : NetStream(std::move(socket));
}

void admit(tcp::socket socket, const Endpoint& endpoint, Context& context) {
  error_code gone;
  const tcp::endpoint address = socket.remote_endpoint(gone);
  if (gone) return;
  socket.set_option(tcp::no_delay(true), gone);
  socket.set_option(asio::socket_base::send_buffer_size(kSendBuffer), gone);
  const asio::any_io_executor executor = socket.get_executor();
  auto client = std::make_unique<Client>(stream_of(std::move(socket), endpoint), text_of(address.address()), endpoint);
  client->place = context.connections.admit(client->address, [raw = client.get()] { raw->stream.close(); });
  if (!client->place) return;
  asio::co_spawn(executor, serve(std::move(client), context), asio::detached);
}

// Until the acceptor is closed. Whoever it cannot serve, it goes on.
awaitable<void> accept(tcp::acceptor& acceptor, const Endpoint& endpoint, Context& context) {
  while (acceptor.is_open()) {
    bool failed = false;
    try {
      auto [error, socket] = co_await acceptor.async_accept(kAsTuple);
      failed = static_cast<bool>(error);
      if (!failed) admit(std::move(socket), endpoint, context);
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
  struct ListeningPlace {
    explicit ListeningPlace(asio::io_context& io) : acceptor(io) {}
    tcp::acceptor acceptor;
    std::uint16_t port = 0, stop_port = 0;
    Endpoint endpoint{RequestFilter(0), nullptr, {}};
  };

  Sockets(std::string its_web, Backend backend, const Limits& limits)
      : connections(limits.connections),
        budget(limits.held_bytes),
        handlers(std::make_unique<Pool>(4, 0, "requests")),
        urgent(std::make_unique<Pool>(1, 0, "urgent")),
        context{std::move(its_web),
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
  // Nobody connects any more, and what moves is stopped, while its process is connected.
  void begin_end(const std::string& why) {
    if (std::exchange(context.ending, true)) return;
    error_code ignored;
    for (const auto& place : places) place->acceptor.close(ignored);
    if (!context.backend.end) return end();
    end_after(kStandTimeout);
    context.backend.end(why, [this, path = context.replies] {
      path->post([this] { connections.empty() ? end() : end_after(kLastWords); });
    });
  }
  void end_after(std::chrono::milliseconds time) {
    if (context.closing) return;
    end_timer.expires_after(time);
    end_timer.async_wait([this](error_code cancelled) {
      if (!cancelled) end();
    });
  }
  // Nothing begins any more. Who still answers or says something may end.
  void end() {
    if (std::exchange(context.closing, true)) return;
    connections.end_all();
    if (connections.empty()) return io.stop();
    end_timer.expires_after(kEndTimeout);
    end_timer.async_wait([this](error_code) { io.stop(); });
  }

  Expected<void> open(const Place& wanted) {
    const std::string name = wanted.address + ':' + std::to_string(wanted.port);
    auto place = std::make_unique<ListeningPlace>(io);
    try {
      listen_at(place->acceptor, wanted.address, wanted.port);
    } catch (const boost::system::system_error& failure) {
      return unexpected(ErrorCode::io, failure.code().message(), name);
    }
    place->port = place->acceptor.local_endpoint().port();
    place->endpoint.filter = RequestFilter(place->port);
    if (wanted.tls) {
      place->endpoint.filter = RequestFilter(wanted.tls->names, place->port);
      place->endpoint.tls = make_tls(wanted.tls->chain, wanted.tls->key);
      if (!place->endpoint.tls) return unexpected(ErrorCode::not_accepted, "the certificate is not of its key", name);
    }
    if (auto opened = open_stop(wanted, *place); !opened) return opened;
    places.push_back(std::move(place));
    return {};
  }

  // The stop server of a place takes requests of its pages, by its names with another port.
  Expected<void> open_stop(const Place& wanted, ListeningPlace& place) {
    const RequestFilter& filter = place.endpoint.filter;
    const auto names = [&](std::uint16_t port) {
      const RequestFilter own = wanted.tls ? RequestFilter(wanted.tls->names, port) : RequestFilter(port);
      for (const std::string& origin : own.origins)
        if (origin.find('[') == std::string::npos) place.endpoint.stop_sources += ' ' + origin;  // CSP has no IPv6
      return StopNames{own.hosts, filter.origins};
    };
    ASSIGN_OR_RETURN(place.stop_port, stop_server.open(wanted.address, wanted.stop_port, place.endpoint.tls, names));
    return {};
  }

  Connections connections;  // they outlive the coroutines, which end with `io`
  ByteBudget budget;
  asio::io_context io{1};
  asio::signal_set signals{io, SIGINT, SIGTERM};  // from here on: one that comes before run() ends it, too
  asio::steady_timer end_timer{io};
  std::vector<std::unique_ptr<ListeningPlace>> places;  // coroutines refer to them
  std::unique_ptr<Pool> handlers, urgent;
  Context context;
  StopServer stop_server{[this](const std::string& address) {
    context.backend.stop(Identity{"", Role::process, {}, "", address});
  }};
};

HttpServer::HttpServer(std::unique_ptr<Sockets> sockets) : sockets_(std::move(sockets)) {}
HttpServer::~HttpServer() = default;

Expected<std::unique_ptr<HttpServer>> HttpServer::listen(const std::vector<Place>& places, std::string web,
                                                         Backend backend, const Limits& limits) {
  auto sockets = std::make_unique<Sockets>(std::move(web), std::move(backend), limits);
  for (const Place& place : places)
    if (auto open = sockets->open(place); !open) return tl::unexpected(std::move(open).error());
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(sockets)));
}

std::uint16_t HttpServer::port(std::size_t place) const { return sockets_->places.at(place)->port; }
std::uint16_t HttpServer::stop_port(std::size_t place) const { return sockets_->places.at(place)->stop_port; }

Expected<void> HttpServer::set_certificate(std::size_t place, const std::string& chain, const std::string& key) {
  auto tls = make_tls(chain, key);
  if (!tls) return unexpected(ErrorCode::not_accepted, "the certificate is not of its key");
  sockets_->stop_server.set_certificate(place, tls);
  asio::post(sockets_->io, [&endpoint = sockets_->places.at(place)->endpoint, tls] { endpoint.tls = tls; });
  return {};
}

void HttpServer::run() {
  services::shorten_time_slice();
  sockets_->stop_server.begin();
  sockets_->context.urgent.post(services::shorten_time_slice);
  sockets_->signals.async_wait([this](error_code failed, int number) {
    if (failed) return;
    error_code ignored;
    sockets_->signals.remove(number, ignored);  // once more, it does what it does to any process
    sockets_->begin_end(number == SIGINT ? "SIGINT" : "SIGTERM");
  });
  for (const auto& place : sockets_->places)
    asio::co_spawn(sockets_->io, accept(place->acceptor, place->endpoint, sockets_->context), asio::detached);
  // What throws there has ended a handler; the others go on.
  while (!services::run_reporting("the sockets", [this] { sockets_->io.run(); })) continue;
}

void HttpServer::stop() {
  asio::post(sockets_->io, [this] { sockets_->begin_end("it was asked to"); });
}

}  // namespace race::server
