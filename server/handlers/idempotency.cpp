#include "server/handlers/idempotency.h"

#include <memory>
#include <utility>

#include "core/rcm/ids.h"
#include "core/value/json.h"
#include "server/http/encode_part.h"
#include "server/http/refusal.h"

namespace race::server {
namespace {

constexpr std::string_view kHeader = "idempotency-key";

Expected<std::string> read_key(const Request& request) {
  std::string_view key = request.header(kHeader);
  if (key.size() > 2 && key.front() == '"' && key.back() == '"') key = key.substr(1, key.size() - 2);
  if (request.count(kHeader) == 1 && rcm::is_id(std::string(key))) return std::string(key);
  return unexpected(ErrorCode::out_of_range, "must be one of 1 to 64 of A-Z a-z 0-9 _ -", "Idempotency-Key");
}

sqlite::Digest digest_of(const Request& request) {
  std::string query;
  for (const auto& [name, value] : request.query) query += encode_part(name) + "=" + encode_part(value) + "&";
  return sqlite::sha256_of({request.method, request.path, query, request.body});
}

}  // namespace

std::size_t bytes_of(const Reply& reply) {
  std::size_t bytes = reply.type.empty() ? to_json(reply.body).size() : reply.text.size();
  for (const auto& [name, value] : reply.headers) bytes += name.size() + value.size();
  return bytes;
}

// The request of a key that is being answered: without an answer to keep, the key is free again.
class IdempotentAnswers::UnderWay {
 public:
  UnderWay(IdempotentAnswers& answers, std::string key) : answers_(answers), key_(std::move(key)) {}
  UnderWay(const UnderWay&) = delete;
  ~UnderWay() {
    if (!ended_) answers_.forget(key_);
  }
  /// Before the reply is sent: the client may ask again then.
  void end(const Reply& reply) {
    if (reply.status < 300)
      answers_.keep(key_, reply);
    else
      answers_.forget(key_);
    ended_ = true;
  }

 private:
  IdempotentAnswers& answers_;
  const std::string key_;
  bool ended_ = false;
};

void IdempotentAnswers::answer(const Request& request, const std::function<void(TakeReply)>& make, TakeReply reply) {
  if (request.count(kHeader) == 0) return make(std::move(reply));
  const auto key = read_key(request);
  if (!key) return reply(refusal(std::vector<Error>{key.error()}));
  if (auto known = find_or_begin(*key, digest_of(request))) return reply(std::move(*known));
  make([under_way = std::make_shared<UnderWay>(*this, *key), reply = std::move(reply)](Reply made) {
    under_way->end(made);
    reply(std::move(made));
  });
}

std::optional<Reply> IdempotentAnswers::find_or_begin(const std::string& key, const sqlite::Digest& request) {
  const services::MutexLock lock(mutex_);
  const auto [found, is_new] = entries_.try_emplace(key, Entry{request, {}, 0, {}});
  if (is_new) return std::nullopt;
  const Entry& entry = found->second;
  const auto refuse = [](int status, std::string why) {
    return refusal(status, std::vector<Error>{{ErrorCode::conflict, std::move(why), "Idempotency-Key"}});
  };
  if (entry.request != request) return refuse(422, "another request had this key");
  if (!entry.reply) return refuse(409, "the request of this key is under way; ask again");
  Reply again = *entry.reply;
  again.headers.emplace_back("Idempotency-Replayed", "true");
  return again;
}

void IdempotentAnswers::keep(const std::string& key, const Reply& reply) {
  Reply kept = reply;
  kept.body.freeze();
  const std::size_t bytes = bytes_of(kept);
  const services::MutexLock lock(mutex_);
  Entry& entry = entries_.at(key);
  entry.reply = std::move(kept);
  entry.bytes = bytes;
  entry.age = ages_.insert(ages_.end(), key);
  bytes_ += bytes;
  forget_oldest();
}

void IdempotentAnswers::forget(const std::string& key) {
  const services::MutexLock lock(mutex_);
  entries_.erase(key);
}

void IdempotentAnswers::clear() {
  const services::MutexLock lock(mutex_);
  for (const std::string& key : ages_) entries_.erase(key);
  ages_.clear();
  bytes_ = 0;
}

void IdempotentAnswers::forget_oldest() {
  while (ages_.size() > limits_.answers || bytes_ > limits_.bytes) {
    const auto oldest = entries_.find(ages_.front());
    bytes_ -= oldest->second.bytes;
    entries_.erase(oldest);
    ages_.pop_front();
  }
}

}  // namespace race::server
