#include "server/http/session.h"

#include "services/failures.h"

namespace race::server {
namespace {

constexpr std::chrono::seconds kMessageTimeout{10};  // for the other side to take a message
constexpr const char* kServerEnds = "the server ends";
constexpr std::chrono::seconds kIdentityCheck{1};  // between two questions whether a client still is who it was
constexpr unsigned kCloseCodes = 5000;             // RFC 6455, 7.4.2: of all close codes, the first that is none
constexpr std::array<unsigned char, 4> kProtocolError = {0x88, 2, 0x03, 0xea};  // a close frame with the code 1002

}  // namespace

awaitable<bool> Session::accept(const Upgrade& request, std::size_t limit, Connections::Place& place) {
  beast::get_lowest_layer(socket_).expires_never();
  socket_.read_message_max(limit);
  socket_.auto_fragment(false);
  socket_.control_callback([this](websocket::frame_type kind, beast::string_view) {
    if (kind == websocket::frame_type::close) check_close_code();
  });
  const auto [failed] = co_await socket_.async_accept(request, kAsTuple);
  if (failed) co_return false;
  place.on_end([weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->end(websocket::close_code::going_away);
  });
  co_return true;
}

void Session::spawn(std::function<awaitable<void>()> coroutine) {
  asio::co_spawn(executor_, std::move(coroutine), [self = shared_from_this()](std::exception_ptr failure) {
    if (!failure) return;
    services::run_reporting("a WebSocket", [&] { std::rethrow_exception(failure); });
    self->close();
  });
}

awaitable<void> Session::check_identity(const Identity& identity, const ClientRecords& records) {
  while (!over_) {
    identity_timer_.expires_after(kIdentityCheck);
    co_await identity_timer_.async_wait(kAsTuple);
    if (!over_ && !records.is_current(identity)) co_return end(websocket::close_code::policy_error);
  }
}

awaitable<void> Session::sleep() {
  waker_.expires_at(std::chrono::steady_clock::time_point::max());
  co_await waker_.async_wait(kAsTuple);
}

awaitable<bool> Session::send(std::vector<asio::const_buffer> pieces) {
  deadline_.expires_after(kMessageTimeout);
  deadline_.async_wait([this, self = shared_from_this()](error_code cancelled) {
    if (!cancelled) reset();
  });
  sending_ = true;
  const auto [error, bytes] = co_await socket_.async_write(pieces, kAsTuple);
  sending_ = false;
  deadline_.cancel();
  co_return !error;
}

void Session::reset() {
  error_code ignored;
  beast::get_lowest_layer(socket_).socket().set_option(asio::socket_base::linger(true, 0), ignored);
  close();
}

void Session::end(websocket::close_code why) {
  if (std::exchange(ending_, true)) return;
  // A client that is told to go away is told why: only the end of the server does that.
  const char* reason = why == websocket::close_code::going_away ? kServerEnds : "";
  socket_.async_close(websocket::close_reason(why, reason), [self = shared_from_this()](error_code) {});
}

// Beast answers each code from 3000 on with itself. Those from 5000 on are none: a protocol error, which is said at
// once, if nothing else is being said, and the connection ends before Beast can answer.
void Session::check_close_code() {
  if (socket_.reason().code < kCloseCodes) return;
  NetStream& stream = beast::get_lowest_layer(socket_);
  if (stream.has_tls()) return reset();  // a frame would have to be encrypted, in its turn
  auto& socket = stream.socket();
  error_code failed;
  socket.non_blocking(true, failed);
  if (sending_ || ending_ || socket.write_some(asio::buffer(kProtocolError), failed) < kProtocolError.size())
    return reset();
  socket.shutdown(asio::socket_base::shutdown_send, failed);
  close();
}

}  // namespace race::server
