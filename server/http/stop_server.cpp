#include "server/http/stop_server.h"

#include <boost/asio/read_until.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <list>
#include <thread>
#include <utility>
#include <vector>

#include "server/http/listening.h"
#include "server/http/net_stream.h"
#include "services/failures.h"
#include "services/thread_name.h"
#include "services/time_slice.h"

namespace race::server {
namespace {

using asio::ip::tcp;
using namespace std::chrono_literals;

constexpr auto kGreetingTimeout = 3s;  // for the handshake of TLS
constexpr auto kHeaderTimeout = 2s;
constexpr auto kAnswerTimeout = 2s;
constexpr auto kPause = 100ms;  // out of descriptors or memory: it will be given back

struct StopClient {
  NetStream stream;
  std::string address;
};

}  // namespace

struct StopServer::Sockets {
  struct StopPlace {
    explicit StopPlace(asio::io_context& io) : acceptor(io) {}
    tcp::acceptor acceptor;
    std::shared_ptr<asio::ssl::context> tls;
    StopNames names;
  };
  using Clients = std::list<StopClient*>;

  explicit Sockets(std::function<void(const std::string&)> its_stop) : stop(std::move(its_stop)) {}

  awaitable<void> accept(StopPlace& place) {
    while (place.acceptor.is_open()) {
      auto [error, socket] = co_await place.acceptor.async_accept(kAsTuple);
      if (!error) {
        admit(std::move(socket), place);
        continue;
      }
      asio::steady_timer pause(io, kPause);
      co_await pause.async_wait(kAsTuple);
    }
  }

  void admit(tcp::socket socket, const StopPlace& place) {
    error_code gone;
    const std::string address = text_of(socket.remote_endpoint(gone).address());
    if (gone) return;
    socket.set_option(tcp::no_delay(true), gone);
    if (clients.size() >= kMostClients) clients.front()->stream.close();
    auto stream = place.tls ? NetStream(std::move(socket), *place.tls) : NetStream(std::move(socket));
    asio::co_spawn(io, serve(std::make_unique<StopClient>(StopClient{std::move(stream), address}), place),
                   asio::detached);
  }

  awaitable<void> serve(std::unique_ptr<StopClient> client, const StopPlace& place) {
    const auto own = clients.insert(clients.end(), client.get());
    try {
      co_await answer(*client, place);
    } catch (...) {
      services::report_failure("who stops the cell");
    }
    clients.erase(own);
  }

  // The cell is stopped before anything is answered.
  awaitable<void> answer(StopClient& client, const StopPlace& place) {
    client.stream.expires_after(kGreetingTimeout);
    const NetStream::Greeting greeting = co_await client.stream.handshake();
    if (greeting != NetStream::Greeting::done) co_return;
    std::string header;
    client.stream.expires_after(kHeaderTimeout);
    auto buffer = asio::dynamic_buffer(header, kHeaderBytes);
    const auto [error, bytes] = co_await asio::async_read_until(client.stream, buffer, "\r\n\r\n", kAsTuple);
    if (error && error != asio::error::not_found) co_return;
    const StopAnswer said = error ? StopAnswer() : answer_stop(std::string_view(header).substr(0, bytes), place.names);
    if (said.status == 200) stop(client.address);
    const std::string text = stop_response(said);
    client.stream.expires_after(kAnswerTimeout);
    const auto piece = asio::buffer(text);
    const auto [failed, sent] = co_await asio::async_write(client.stream, piece, kAsTuple);
    if (failed) co_return;
    error_code ignored;
    client.stream.socket().shutdown(tcp::socket::shutdown_send, ignored);
    // What it still sends is taken, for a while: closing would reset the connection before it has read the answer.
    header.resize(kHeaderBytes);
    const auto rest = asio::buffer(header);
    for (std::size_t pieces = 0; pieces < 64; ++pieces) {
      const auto [ended, taken] = co_await client.stream.async_read_some(rest, kAsTuple);
      if (ended) co_return;
    }
  }

  const std::function<void(const std::string&)> stop;
  asio::io_context io{1};
  std::vector<std::unique_ptr<StopPlace>> places;  // coroutines refer to them
  Clients clients;                                 // in the order in which they came
  std::thread thread;
};

StopServer::StopServer(std::function<void(const std::string&)> stop)
    : sockets_(std::make_unique<Sockets>(std::move(stop))) {}

StopServer::~StopServer() {
  sockets_->io.stop();
  if (sockets_->thread.joinable()) sockets_->thread.join();
}

Expected<std::uint16_t> StopServer::open(const std::string& address, std::uint16_t port,
                                         std::shared_ptr<asio::ssl::context> tls,
                                         const std::function<StopNames(std::uint16_t)>& names) {
  auto place = std::make_unique<Sockets::StopPlace>(sockets_->io);
  try {
    listen_at(place->acceptor, address, port);
  } catch (const boost::system::system_error& failure) {
    return unexpected(ErrorCode::io, failure.code().message(), address + ':' + std::to_string(port));
  }
  const std::uint16_t own = place->acceptor.local_endpoint().port();
  place->tls = std::move(tls);
  place->names = names(own);
  sockets_->places.push_back(std::move(place));
  return own;
}

void StopServer::set_certificate(std::size_t place, std::shared_ptr<asio::ssl::context> tls) {
  asio::post(sockets_->io, [&place = *sockets_->places.at(place), tls = std::move(tls)] { place.tls = tls; });
}

void StopServer::begin() {
  for (const auto& place : sockets_->places) asio::co_spawn(sockets_->io, sockets_->accept(*place), asio::detached);
  sockets_->thread = std::thread([sockets = sockets_.get()] {
    services::name_thread("stop");
    services::shorten_time_slice();
    while (!services::run_reporting("the stop server", [&] { sockets->io.run(); })) continue;
  });
}

}  // namespace race::server
