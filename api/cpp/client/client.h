// Client: asks one server, over connections of its own for each request; the caller waits. calls.h has a function for
// each route, which send() sends:
//
//   const auto race = client::Client::create("http://127.0.0.1:8080");
//   const auto core = race->send(client::calls::create_core(Dict{{"document", "counter"}}));
//
// Bodies and answers are JSON, as Value, as api/schemas has them.
//
// Threads: any, but log_in() and log_out() while nobody else uses it.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>

#include "api/cpp/client/api_error.h"
#include "api/cpp/client/call.h"
#include "api/cpp/client/following.h"
#include "server/http/client.h"

namespace race::client {

struct ClientOptions {
  std::string token = {};                     // of an account (`race account token`); empty: none
  std::string authority = {};                 // of an https server, as PEM file (tls/ca.pem of its data folder); empty:
                                              // those that this machine trusts
  std::chrono::milliseconds timeout{20'000};  // for each answer, greater than 0
};

class Client {
 public:
  /// Of `http://127.0.0.1:8080`, or `https://HOST[:PORT]` of another machine. Connects to nothing yet. Error
  /// `argument`: it is none, is http to another machine, which would show it a token, or the token has characters that
  /// none has.
  static Answered<Client> create(std::string url, const ClientOptions& options = {});

  /// The answer to a request: a JSON object, or of a call with is_text a string. Errors: the server's (with a status),
  /// or `connection`, `protocol` and `argument`.
  Answered<Value> send(const Call& call) const;

  /// Asks as this account from now on, for twelve hours at most. Errors: 401 `login`, 429 `attempts`.
  Answered<Value> log_in(std::string_view name, std::string_view password);
  /// Ends the token; the server knows this client no more.
  Answered<Value> log_out();

  /// Follows a core until its run is over; when this returns, its first snapshot has come. `within`: for that; else as
  /// for an answer. Errors: those of Following::next(), and those with which the server opens no stream (401 `login`).
  Answered<Following> follow(std::string_view core, std::chrono::milliseconds within) const;
  Answered<Following> follow(std::string_view core) const { return follow(core, timeout_); }

 private:
  Client(server::HttpClient http, std::chrono::milliseconds timeout) : http_(std::move(http)), timeout_(timeout) {}

  server::HttpClient http_;
  std::chrono::milliseconds timeout_;
};

}  // namespace race::client
