// Following: a core that is followed over the stream (Client::follow): a snapshot, then deltas, until its run is over.
// A thread of its own reads beside its user and folds deltas, so a slow user does not lose the connection: beyond 1000
// updates that wait, one snapshot takes the place of all (Update::merged). A connection that is lost is not made again:
// who follows anew gets a snapshot.
//
// Threads: one at a time. It ends when it is destroyed, at once.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string_view>

#include "api/cpp/client/api_error.h"
#include "api/cpp/client/core_updates.h"

namespace race::server {
class HttpClient;
}  // namespace race::server

namespace race::client {

class Following {
 public:
  Following(Following&& other) noexcept;
  Following& operator=(Following&& other) noexcept;
  ~Following();

  /// The next update; nothing: the run is over, and its last update was read. Errors: `timeout`: none comes in time,
  /// and it may be asked again; behind all updates that came before: `connection`, `protocol`, or those of the server,
  /// such as `not_found`: the core is gone.
  Answered<std::optional<Update>> next(std::chrono::milliseconds timeout);

 private:
  friend class Client;
  struct Reader;
  explicit Following(std::unique_ptr<Reader> reader);
  // Waits for the first snapshot.
  static Answered<Following> open(const server::HttpClient& http, std::string_view core,
                                  std::chrono::milliseconds within);

  std::unique_ptr<Reader> reader_;
};

}  // namespace race::client
