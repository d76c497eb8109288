// HttpClient: requests to a server, for commands. Each has a connection of its own; the caller waits. Boost stays in
// client.cpp.
//
// Threads: any.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/remote/address.h"

namespace race::server {

class HttpClient {
 public:
  /// What a server answered: the HTTP status, and the body, which is JSON.
  struct Answer {
    int status = 0;
    Value body;
  };
  /// The same with a body that may be anything.
  struct TextAnswer {
    int status = 0;
    std::string body;
  };
  using Headers = std::vector<std::pair<std::string, std::string>>;
  /// Greater than 0. A handler of the server answers within seven seconds (handlers/README.md).
  struct Timeouts {
    std::chrono::milliseconds connect{3'000};
    std::chrono::milliseconds answer{30'000};  // from the connection to the last byte
  };
  static constexpr std::size_t kBodyBytes = 16 * 1024 * 1024;  // of an answer
  static constexpr std::size_t kBodyDepth = 2048;              // levels of an answer: derivations are deep

  /// Of the server at `url`, as remote::read_address takes it. Connects to nothing yet. Error `syntax`.
  static Expected<HttpClient> create(std::string url, Timeouts timeouts);
  static Expected<HttpClient> create(std::string url) { return create(std::move(url), Timeouts()); }
  /// Sends the token of an account with each request.
  void set_token(std::string token) { token_ = std::move(token); }
  /// Over TLS, trusts the authority whose certificate is in this file (PEM); empty, as at first: those that the machine
  /// trusts.
  void set_authority(std::string file) { authority_ = std::move(file); }

  /// Sends a request and waits for its answer, whatever its status. `method`: of HTTP, "GET"; `target`: path and query,
  /// encoded (encode_part.h). Errors, with the URL as path: `unavailable` (nothing listens there, or no answer
  /// came in time; the server may have executed it), `io` (what answers speaks no HTTP or no JSON, or more than
  /// kBodyBytes, or it is not trusted); with the file of the authority as path `io`.
  Expected<Answer> request(std::string_view method, std::string_view target, const std::optional<Value>& body = {},
                           const Headers& headers = {}) const;
  /// The same of an answer that may be no JSON.
  Expected<TextAnswer> request_text(std::string_view method, std::string_view target,
                                    const std::optional<Value>& body = {}, const Headers& headers = {}) const;

  /// How a channel is followed.
  struct FollowOptions {
    std::stop_token stop = {};  // once it is stopped, from any thread, follow() returns soon, and without an error
    Answer* refusal = nullptr;  // gets the answer of a server that opens no stream, if it is JSON
  };
  /// Subscribes a channel of the stream (api/asyncapi.yaml), and gives each of its messages, from the snapshot on, to
  /// `take` until that returns false. Errors, with the URL as path: `rights` (the server does not let in who asks), and
  /// those of request(); `unavailable` also if the connection ends.
  Expected<void> follow(std::string_view channel, const std::function<bool(const Value& message)>& take,
                        const FollowOptions& options) const;
  Expected<void> follow(std::string_view channel, const std::function<bool(const Value& message)>& take) const {
    return follow(channel, take, FollowOptions());
  }

 private:
  template <typename Result, typename Use>
  Expected<Result> connect_and(const Use& use, const std::stop_token& stop = {}) const;

  HttpClient(std::string url, remote::Address address, Timeouts timeouts)
      : url_(std::move(url)), address_(std::move(address)), timeouts_(timeouts) {}

  std::string url_;
  remote::Address address_;
  Timeouts timeouts_;
  std::string token_;      // empty: none
  std::string authority_;  // a file
};

}  // namespace race::server
