// NetStream: the socket of a client, with TLS or without. One type for both, so that all of Beast is compiled once:
// what waits for a read or a write is held behind a virtual function.
//
// Threads: the sockets'.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>

#include "server/http/beast.h"

namespace boost::asio::ssl {
class context;
}

namespace race::server {

/// A model of Beast's AsyncStream. Handlers run on the executor of the socket.
class NetStream {
 public:
  using executor_type = asio::any_io_executor;
  /// Of a write [bytes], which the kernel copies on the sockets' thread.
  static constexpr std::size_t kMostAtOnce = 64 * 1024;

  explicit NetStream(asio::ip::tcp::socket socket);
  /// With TLS, of which handshake() is the first step. The context outlives it.
  NetStream(asio::ip::tcp::socket socket, asio::ssl::context& tls);
  NetStream(NetStream&&) noexcept;
  NetStream& operator=(NetStream&&) = delete;
  ~NetStream();

  executor_type get_executor() { return tcp_->get_executor(); }
  asio::ip::tcp::socket& socket() { return tcp_->socket(); }
  bool has_tls() const { return static_cast<bool>(tls_); }
  /// How long what follows may take; beyond it, it ends with beast::error::timeout.
  void expires_after(std::chrono::milliseconds time) { tcp_->expires_after(time); }
  void expires_never() { tcp_->expires_never(); }
  void close() { tcp_->close(); }
  /// Whether the client has closed its half of the connection; requires that the socket is ready to be read.
  bool is_ended();
  enum class Greeting { done, failed, plain_http };
  /// As the server; without TLS, nothing. plain_http: the client has spoken that where TLS is spoken, and can be
  /// answered without it; what it has said is lost.
  awaitable<Greeting> handshake();

  template <typename Buffers, typename Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    return asio::async_initiate<Token, void(error_code, std::size_t)>(
        [this](auto handler, asio::mutable_buffer into) { start_read(into, erase(std::move(handler))); }, token,
        first_of<asio::mutable_buffer>(buffers));
  }
  /// At most kMostAtOnce, so that all who are written to take turns, and whoever asks for little waits for few of them.
  template <typename Buffers, typename Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    Pieces pieces{};
    std::size_t count = 0, left = kMostAtOnce;
    for (auto each = asio::buffer_sequence_begin(buffers);
         each != asio::buffer_sequence_end(buffers) && count < pieces.size() && left > 0; ++each)
      if (const asio::const_buffer piece = asio::buffer(asio::const_buffer(*each), left); piece.size() > 0) {
        pieces[count++] = piece;
        left -= piece.size();
      }
    return asio::async_initiate<Token, void(error_code, std::size_t)>(
        [this](auto handler, const Pieces& from) { start_write(from, erase(std::move(handler))); }, token, pieces);
  }

 private:
  using Pieces = std::array<asio::const_buffer, 8>;  // empty ones at the end

  // What is done with the result of a read or write. Used once.
  struct Completion {
    Completion() = default;
    Completion(const Completion&) = delete;
    Completion& operator=(const Completion&) = delete;
    virtual ~Completion() = default;
    virtual void complete(error_code error, std::size_t bytes) = 0;
  };
  using CompletionOwner = std::unique_ptr<Completion>;
  template <typename Handler>
  struct HandlerCompletion final : Completion {
    explicit HandlerCompletion(Handler its_handler) : handler(std::move(its_handler)) {}
    void complete(error_code error, std::size_t bytes) override { std::move(handler)(error, bytes); }
    Handler handler;
  };
  template <typename Handler>
  static CompletionOwner erase(Handler handler) {
    return std::make_unique<HandlerCompletion<Handler>>(std::move(handler));
  }
  // Reads into the first buffer that is not empty: who wants more asks again.
  template <typename Buffer, typename Buffers>
  static Buffer first_of(const Buffers& buffers) {
    for (auto each = asio::buffer_sequence_begin(buffers); each != asio::buffer_sequence_end(buffers); ++each)
      if (Buffer buffer(*each); buffer.size() > 0) return buffer;
    return {};
  }

  void start_read(asio::mutable_buffer into, CompletionOwner done);
  void start_write(const Pieces& from, CompletionOwner done);

  struct Tls;
  std::unique_ptr<beast::tcp_stream> tcp_;  // TLS refers to it
  std::unique_ptr<Tls> tls_;
};

// What Beast's WebSockets ask for of a stream that is none of its own.
void beast_close_socket(NetStream& stream);
void teardown(beast::role_type role, NetStream& stream, error_code& error);
template <typename Handler>
void async_teardown(beast::role_type role, NetStream& stream, Handler&& handler) {
  websocket::async_teardown(role, stream.socket(), std::forward<Handler>(handler));
}

}  // namespace race::server
