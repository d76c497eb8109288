#include "api/cpp/client/following.h"

#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "server/http/client.h"
#include "services/mutex.h"

namespace race::client {

using server::HttpClient;
using services::MutexLock;

struct Following::Reader {
  Reader(HttpClient from, std::string_view core)
      : http(std::move(from)),
        updates(core),
        channel(updates.channel()),
        thread([this](const std::stop_token& stop) { read(stop); }) {}

  // Until the run is over, or there is nothing more to hear.
  void read(const std::stop_token& stop) EXCLUDES(mutex) {
    HttpClient::Answer refusal_of_stream;
    const auto take = [this](const Value& message) {
      const MutexLock lock(mutex);
      updates.receive(message);
      changed.notify_all();
      return !updates.is_over();
    };
    const auto done = http.follow(channel, take, {.stop = stop, .refusal = &refusal_of_stream});
    if (done) return;
    const MutexLock lock(mutex);
    updates.fail(refusal_of_stream.status != 0 ? refusal(refusal_of_stream.status, refusal_of_stream.body)
                                               : connection_error(done.error()));
    changed.notify_all();
  }

  // Until the first snapshot is there; or why it does not come.
  std::optional<ApiError> wait_for_first(std::chrono::milliseconds within) EXCLUDES(mutex) {
    const MutexLock lock(mutex);
    changed.wait_for(mutex, within, [this]() REQUIRES(mutex) { return updates.has_state() || updates.is_over(); });
    if (updates.has_state()) return std::nullopt;
    if (updates.failure()) return updates.failure();
    return failure(kTimeout, channel + ": no snapshot comes in time").value();
  }

  Answered<std::optional<Update>> next(std::chrono::milliseconds timeout) EXCLUDES(mutex) {
    const MutexLock lock(mutex);
    changed.wait_for(mutex, timeout, [this]() REQUIRES(mutex) { return updates.has_next() || updates.is_over(); });
    if (auto update = updates.pop()) return update;
    if (updates.failure()) return tl::unexpected(*updates.failure());
    if (updates.is_over()) return std::optional<Update>();
    return failure(kTimeout, channel + ": no update comes in time");
  }

  const HttpClient http;
  services::Mutex mutex;
  services::ConditionVariable changed;
  CoreUpdates updates GUARDED_BY(mutex);
  const std::string channel;
  std::jthread thread;  // the first to end, of its own accord or told to
};

Following::Following(std::unique_ptr<Reader> reader) : reader_(std::move(reader)) {}
Following::Following(Following&& other) noexcept = default;
Following& Following::operator=(Following&& other) noexcept = default;
Following::~Following() = default;

Answered<Following> Following::open(const HttpClient& http, std::string_view core, std::chrono::milliseconds within) {
  auto reader = std::make_unique<Reader>(http, core);
  if (auto failed = reader->wait_for_first(within)) return tl::unexpected(std::move(*failed));
  return Following(std::move(reader));
}

Answered<std::optional<Update>> Following::next(std::chrono::milliseconds timeout) { return reader_->next(timeout); }

}  // namespace race::client
