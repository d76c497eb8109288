// Idempotency keys (draft-ietf-httpapi-idempotency-key-header): a client that does not know whether its request has
// arrived sends it again with the same header Idempotency-Key, and gets the answer of the first one; nothing is created
// twice. Answers are kept while the server runs; the oldest go.
//
// Threads: any.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <string>

#include "server/http/message.h"
#include "services/mutex.h"
#include "services/sqlite/digest.h"

namespace race::server {

/// Gets the reply to a request, once.
using TakeReply = std::function<void(Reply)>;

/// Of its body and headers, as it is kept.
std::size_t bytes_of(const Reply& reply);

class IdempotentAnswers {
 public:
  struct Limits {
    std::size_t answers = 1000;
    std::size_t bytes = 32U << 20U;  // of the kept answers
  };
  explicit IdempotentAnswers(Limits limits) : limits_(limits) {}
  IdempotentAnswers() : IdempotentAnswers(Limits{}) {}

  /// Replies what `make` replies, now or later, or has answered when the request came with this key before: then with
  /// the header Idempotency-Replayed. Refusals are not kept, so that the request may be sent again. Without a key,
  /// `make` alone. 400 `out_of_range`: the key is not 1 to 64 of A-Z a-z 0-9 _ -, in quotation marks or not; 409
  /// `conflict`: its first request is under way; 422 `conflict`: its first request was another one.
  void answer(const Request& request, const std::function<void(TakeReply)>& make, TakeReply reply) EXCLUDES(mutex_);

  /// Forgets all answers: what they say was created may be gone.
  void clear() EXCLUDES(mutex_);

 private:
  struct Entry {
    sqlite::Digest request;
    std::optional<Reply> reply;  // nothing: under way
    std::size_t bytes = 0;
    std::list<std::string>::iterator age;  // if there is a reply
  };
  class UnderWay;

  std::optional<Reply> find_or_begin(const std::string& key, const sqlite::Digest& request) EXCLUDES(mutex_);
  void keep(const std::string& key, const Reply& reply) EXCLUDES(mutex_);
  void forget(const std::string& key) EXCLUDES(mutex_);
  void forget_oldest() REQUIRES(mutex_);

  const Limits limits_;
  services::Mutex mutex_;
  std::map<std::string, Entry> entries_ GUARDED_BY(mutex_);
  std::list<std::string> ages_ GUARDED_BY(mutex_);  // keys, the oldest first
  std::size_t bytes_ GUARDED_BY(mutex_) = 0;
};

}  // namespace race::server
