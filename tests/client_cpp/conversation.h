// Conversation: holds one conversation of api/conversations with a server, by the C++ client.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "api/cpp/client/client.h"
#include "core/value/value.h"
#include "tests/client_cpp/values.h"

namespace race::client {

/// A server in which nothing was before, and tokens of its accounts, by their names.
struct TestServer {
  std::string url;
  std::map<std::string, std::string> tokens = {};
};

class Conversation {
 public:
  explicit Conversation(TestServer server);

  /// All steps, one after the other. Throws std::runtime_error: something else came than a step says.
  void hold(const List& steps);

 private:
  std::optional<std::string> hold_step(const Value& step);
  std::optional<std::string> refusal_of(const Value& step, const ApiError& error);
  Answered<Value> outcome(const Value& step);
  Answered<Value> talk(const Value& step, Client& client);
  Answered<Value> follow(const Value& step, Client& client);
  Answered<Value> next(const Value& step);
  Answered<Value> rest();
  Client& client_of(const Value* account);
  Value given(const Value& step, std::string_view field, Value otherwise);
  void save(const Value& step, const Value& answer);

  TestServer server_;
  Values saved_;
  std::map<std::string, Client> clients_;  // by account; empty: without one
  std::optional<Following> updates_;
  std::chrono::milliseconds quiet_{};
};

}  // namespace race::client
