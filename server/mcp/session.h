// Session: one client of the Model Context Protocol, from `initialize` to the end of what it sends.
//
// Threads: receive() and end() on one; requests are worked on by threads of the session, so that none of them holds up
// a ping or a cancellation. Calls that stop something have threads of their own, so that no other call holds them up.
#pragma once

#include <chrono>
#include <string>

#include "server/mcp/api.h"
#include "server/mcp/batch.h"
#include "server/mcp/calls.h"
#include "server/mcp/json_rpc.h"
#include "server/threads/strand.h"

namespace race::server::mcp {

class Session {
 public:
  /// Levels of a message: a document with the 64 that it may have, in the arguments of a call.
  static constexpr std::size_t kDepth = 68;
  static constexpr unsigned kThreads = 8;

  /// `send` outlives the session.
  Session(HttpClient client, Send send) : api_(std::move(client)), send_(std::move(send)) {}

  /// A line of the client. What is wrong with it is sent.
  void receive(const std::string& line);
  /// A line that could not be read.
  void refuse(const Error& error);
  /// The client sends nothing more: what is being worked on has `time`; then it is cancelled, and has so much again.
  /// False: a request hangs, such as in a server that does not answer.
  bool end(std::chrono::milliseconds time);

 private:
  void receive_one(const Value& json, const Respond& respond);
  void receive_batch(const List& messages);
  void handle(Message message, const Respond& respond);
  void work(const Message& message, const Respond& respond);
  void notified(const Message& message);
  tl::expected<Value, RpcError> initialize(const Value& params);

  const Api api_;
  const Send send_;
  std::string version_;  // of the protocol; empty: the client has not initialized
  Calls calls_;
  // Last: their work uses the others.
  Pool pool_{kThreads, 0, "mcp"};
  Pool stops_{Calls::kMostStops, 0, "mcp stops"};
};

}  // namespace race::server::mcp
