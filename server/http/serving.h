// Serving: one HTTP connection, request after request, until it ends or becomes a WebSocket.
//
// Threads: the sockets'.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "server/http/beast.h"
#include "server/http/byte_budget.h"
#include "server/http/connections.h"
#include "server/http/listener.h"
#include "server/http/net_stream.h"
#include "server/http/reply_path.h"
#include "server/http/request_filter.h"
#include "server/threads/strand.h"

namespace race::server {

/// Where clients connect: the names that the server has there, and TLS, if it is spoken there.
struct Endpoint {
  RequestFilter filter;
  std::shared_ptr<asio::ssl::context> tls;  // empty: none
  std::string stop_sources;                 // where its pages may stop the cell, too (ResponseOptions)
};

/// What all connections share.
struct Context {
  std::string web;
  Backend backend;
  Pool& handlers;
  Pool& urgent;                        // handlers of what reserved connections may ask for
  std::shared_ptr<ReplyPath> replies;  // also of answers that come when there are no sockets any more
  Connections& connections;
  ByteBudget& budget;
  HttpServer::Limits limits;
  asio::io_context& io;
  bool ending = false;   // each answer is the last of its connection
  bool closing = false;  // the sockets end when the last connection does
};

/// A connection, until its coroutine ends.
struct Client {
  Client(NetStream its_stream, std::string its_address, const Endpoint& its_endpoint)
      : stream(std::move(its_stream)), address(std::move(its_address)), endpoint(its_endpoint) {}
  NetStream stream;
  beast::flat_buffer buffer{RequestFilter::kHeaderBytes + 64 * 1024};
  std::string address;  // "127.0.0.1"
  const Endpoint& endpoint;
  std::unique_ptr<Connections::Place> place;
};

/// Serves the client until it leaves; the last that leaves while the server ends stops the sockets.
awaitable<void> serve(std::unique_ptr<Client> client, Context& context);

}  // namespace race::server
