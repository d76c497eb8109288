#include "server/http/net_stream.h"

#include <sys/socket.h>

#include <algorithm>
#include <boost/asio/ssl.hpp>
#include <span>
#include <vector>

namespace race::server {
namespace {

constexpr std::size_t kRecord = 16 * 1024;  // the largest of TLS (RFC 8446, 5.1)
constexpr unsigned char kAlert = 21;        // the type of a record that ends a connection (RFC 8446, 5.1)
constexpr std::size_t kWorthARecord = 4 * 1024;

bool is_plain_http(const error_code& error) {
  return error.category() == asio::error::get_ssl_category() &&
         ERR_GET_REASON(static_cast<unsigned long>(error.value())) == SSL_R_HTTP_REQUEST;
}

}  // namespace

struct NetStream::Tls {
  Tls(beast::tcp_stream& tcp, asio::ssl::context& context) : stream(tcp, context) {}

  // What goes out as one record: pieces that are small together, as each record costs.
  asio::const_buffer gather(const Pieces& pieces) {
    if (pieces[0].size() >= kWorthARecord || pieces[1].size() == 0) return pieces[0];
    record.clear();
    for (const asio::const_buffer& piece : pieces) {
      const std::span<const char> bytes(static_cast<const char*>(piece.data()), piece.size());
      const auto fits = bytes.first(std::min(bytes.size(), kRecord - record.size()));
      record.insert(record.end(), fits.begin(), fits.end());
    }
    return asio::buffer(record);
  }

  asio::ssl::stream<beast::tcp_stream&> stream;
  std::vector<char> record;  // while it is written
};

NetStream::NetStream(asio::ip::tcp::socket socket) : tcp_(std::make_unique<beast::tcp_stream>(std::move(socket))) {}
NetStream::NetStream(asio::ip::tcp::socket socket, asio::ssl::context& tls) : NetStream(std::move(socket)) {
  tls_ = std::make_unique<Tls>(*tcp_, tls);
}
NetStream::NetStream(NetStream&&) noexcept = default;
NetStream::~NetStream() = default;

bool NetStream::is_ended() {
  error_code failed;
  if (socket().available(failed) == 0) return true;
  unsigned char first = 0;
  return tls_ && ::recv(socket().native_handle(), &first, 1, MSG_PEEK | MSG_DONTWAIT) == 1 && first == kAlert;
}

awaitable<NetStream::Greeting> NetStream::handshake() {
  if (!tls_) co_return Greeting::done;
  const auto [error] = co_await tls_->stream.async_handshake(asio::ssl::stream_base::server, kAsTuple);
  if (!error) co_return Greeting::done;
  if (!is_plain_http(error)) co_return Greeting::failed;
  tls_.reset();
  co_return Greeting::plain_http;
}

void NetStream::start_read(asio::mutable_buffer into, CompletionOwner done) {
  auto complete = [done = std::move(done)](error_code error, std::size_t bytes) { done->complete(error, bytes); };
  if (tls_)
    tls_->stream.async_read_some(into, std::move(complete));
  else
    tcp_->async_read_some(into, std::move(complete));
}

void NetStream::start_write(const Pieces& from, CompletionOwner done) {
  auto complete = [done = std::move(done)](error_code error, std::size_t bytes) { done->complete(error, bytes); };
  if (tls_)
    tls_->stream.async_write_some(tls_->gather(from), std::move(complete));
  else
    tcp_->async_write_some(from, std::move(complete));
}

void beast_close_socket(NetStream& stream) { stream.close(); }

void teardown(beast::role_type role, NetStream& stream, error_code& error) {
  websocket::teardown(role, stream.socket(), error);
}

}  // namespace race::server
