#include "services/remote/socket_client.h"

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <thread>

#include "services/remote/protocol.h"

namespace race::remote {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;

constexpr auto kAsTuple = asio::as_tuple(asio::use_awaitable);
constexpr std::chrono::seconds kHandshake(3);
constexpr const char* kTarget = "/api/v1/components";

}  // namespace

// Everything on the one thread of `io`, but for what wakes it.
struct SocketClient::Socket {
  Socket(SendQueue& its_out, Handlers its_handlers) : out(its_out), handlers(std::move(its_handlers)) {}

  // Errors of the network; of what is there if it is no server of ours.
  asio::awaitable<Expected<void>> open(const Address& address, const std::string& token) {
    const std::string port = std::to_string(address.port), name = address.host + ":" + port;
    tcp::resolver resolver(io);
    const auto [unknown, endpoints] = co_await resolver.async_resolve(address.host, port, kAsTuple);
    if (unknown) co_return failure(unknown);
    auto& lowest = beast::get_lowest_layer(stream);
    lowest.expires_after(kHandshake);
    const auto [absent, endpoint] = co_await lowest.async_connect(endpoints, kAsTuple);
    if (absent) co_return failure(absent);
    error_code ignored;
    lowest.socket().set_option(tcp::no_delay(true), ignored);
    stream.read_message_max(kMessageBytes);
    stream.auto_fragment(false);
    stream.set_option(websocket::stream_base::decorator([token](websocket::request_type& request) {
      if (!token.empty()) request.set(beast::http::field::authorization, "Bearer " + token);
    }));
    websocket::response_type answer;
    const auto [refused] = co_await stream.async_handshake(answer, name, kTarget, kAsTuple);
    if (answer.result() == beast::http::status::service_unavailable)
      co_return unexpected(ErrorCode::unavailable, "has no room for another connection");
    if (answer.result() == beast::http::status::unauthorized || answer.result() == beast::http::status::forbidden)
      co_return unexpected(ErrorCode::rights, "does not accept this token for a process of services");
    if (refused == websocket::error::upgrade_declined)
      co_return unexpected(ErrorCode::conflict,
                           "answers " + std::to_string(answer.result_int()) + " where components are let in");
    if (refused) co_return failure(refused);
    lowest.expires_never();
    co_return Expected<void>();
  }

  static tl::unexpected<Error> failure(error_code error) { return unexpected(ErrorCode::unavailable, error.message()); }

  asio::awaitable<void> read() {
    beast::flat_buffer buffer(kMessageBytes + 1024);
    std::string why;
    try {
      for (;;) {
        const auto [error, bytes] = co_await stream.async_read(buffer, kAsTuple);
        if (error) {
          why = error.message();
          break;
        }
        handlers.received({beast::buffers_to_string(buffer.cdata()), stream.got_binary()});
        buffer.consume(buffer.size());
      }
    } catch (const std::exception& failure) {  // such as without memory
      why = failure.what();
    }
    over = true;
    out.on_change({});
    waker.cancel();
    handlers.closed(why);
  }

  asio::awaitable<void> write() {
    out.on_change([this] {
      asio::post(io, [this] {
        waker.cancel();
        // The server reads nothing: what is being written will not end.
        if (out.overflowed()) beast::get_lowest_layer(stream).close();
      });
    });
    while (!over) {
      while (auto encoded = out.pop()) {
        stream.binary(encoded->binary);
        const auto [error, bytes] = co_await stream.async_write(asio::buffer(encoded->bytes), kAsTuple);
        if (error || over) co_return beast::get_lowest_layer(stream).close();
      }
      if (out.drained()) co_return beast::get_lowest_layer(stream).close();
      waker.expires_at(std::chrono::steady_clock::time_point::max());
      co_await waker.async_wait(kAsTuple);
    }
  }

  SendQueue& out;
  Handlers handlers;
  asio::io_context io{1};
  websocket::stream<beast::tcp_stream> stream{io};
  asio::steady_timer waker{io};
  bool over = false;
  std::thread thread;
};

SocketClient::SocketClient(std::unique_ptr<Socket> socket) : socket_(std::move(socket)) {}

Expected<std::unique_ptr<SocketClient>> SocketClient::connect(const Address& address, const std::string& token,
                                                              SendQueue& out, Handlers handlers) {
  auto socket = std::make_unique<Socket>(out, std::move(handlers));
  Expected<void> opened;
  asio::co_spawn(socket->io, socket->open(address, token), [&](std::exception_ptr failure, Expected<void> result) {
    if (!failure)
      opened = std::move(result);
    else
      opened = unexpected(ErrorCode::unavailable, "the connection failed");
  });
  socket->io.run();
  if (!opened) return tl::unexpected(std::move(opened).error());
  socket->io.restart();
  asio::co_spawn(socket->io, socket->read(), asio::detached);
  asio::co_spawn(socket->io, socket->write(), asio::detached);
  socket->thread = std::thread([raw = socket.get()] { raw->io.run(); });
  return std::unique_ptr<SocketClient>(new SocketClient(std::move(socket)));
}

SocketClient::~SocketClient() {
  socket_->out.on_change({});
  socket_->io.stop();
  socket_->thread.join();
}

}  // namespace race::remote
