#include "services/remote/process_session.h"

#include <chrono>
#include <thread>
#include <utility>

#include "services/remote/protocol.h"

namespace race::remote {

ProcessSession::ProcessSession(ProcessHost& process, Options options)
    : process_(process), options_(std::move(options)) {}

Expected<std::unique_ptr<ProcessSession>> ProcessSession::connect(const Address& address, const std::string& token,
                                                                  ProcessHost& process, SendQueue& out,
                                                                  Options options) {
  std::unique_ptr<ProcessSession> session(new ProcessSession(process, std::move(options)));
  ProcessSession* const raw = session.get();
  ASSIGN_OR_RETURN(session->socket_,
                   SocketClient::connect(address, token, out,
                                         {[raw](const EncodedMessage& encoded) { raw->received(encoded); },
                                          [raw](std::string why) { raw->end(std::move(why)); }}));
  out.push(encode(process.hello()).value());
  process.connect(out, [raw] { return raw->options_.stop || raw->over_; });
  return session;
}

ProcessSession::~ProcessSession() {
  socket_.reset();
  process_.disconnect();
}

// On the socket's thread. The group may wait for a reply; all else is queued for it.
void ProcessSession::received(const EncodedMessage& encoded) {
  auto message = decode(encoded, Reader::process);
  if (!message) return end_invalid(message.error());
  if (message->kind == Kind::refused) {
    {
      const services::MutexLock lock(mutex_);
      refusal_ = std::move(message->value.freeze());
    }
    return end("the server does not accept it");
  }
  if (message->kind == Kind::reply) return process_.handle_reply(std::move(*message));
  if (message->kind == Kind::welcome) options_.welcomed();
  if (!process_.receive(std::move(*message), encoded.bytes.size())) end("the server says more than is handled");
}

void ProcessSession::end(std::string why) {
  const services::MutexLock lock(mutex_);
  if (why_.empty()) why_ = std::move(why);
  over_ = true;
}

void ProcessSession::end_invalid(const Error& error) { end("invalid message from the server: " + to_string(error)); }

void ProcessSession::run() {
  using namespace std::chrono_literals;
  using std::chrono::steady_clock;
  auto next = steady_clock::now();
  while (!options_.stop && !over_) {
    next += 1ms;
    std::this_thread::sleep_until(next);
    if (const auto now = steady_clock::now(); now - next > 100ms) next = now;
    if (auto stepped = process_.step(); !stepped) end_invalid(stepped.error());
  }
}

std::string ProcessSession::reason() const {
  const services::MutexLock lock(mutex_);
  return why_;
}

Value ProcessSession::refusal() const {
  const services::MutexLock lock(mutex_);
  return refusal_;
}

}  // namespace race::remote
