#include "api/cpp/client/core_updates.h"

#include <algorithm>
#include <utility>

#include "api/cpp/client/fold.h"

namespace race::client {
namespace {

std::string_view text_of(const Value& message, std::string_view field) {
  const Value* const text = message.find(field);
  return text && text->is_string() ? std::string_view(text->as_string()) : std::string_view();
}

}  // namespace

CoreUpdates::CoreUpdates(std::string_view core, std::size_t capacity)
    : channel_("core/" + std::string(core) + "/state"), capacity_(capacity) {}

void CoreUpdates::receive(const Value& message) {
  const std::string_view channel = text_of(message, "channel");
  const bool is_ours = channel == channel_;
  if (text_of(message, "kind") == "error" && (is_ours || channel.empty())) {
    const Value* const errors = message.find("data");
    return fail(refusal(0, errors ? *errors : Value()));
  }
  if (is_ours) take(message);
}

void CoreUpdates::take(const Value& message) {
  const Value* const number = message.find("sequence");
  const Value* const data = message.find("data");
  const std::string_view kind = text_of(message, "kind");
  const auto refuse = [this] {
    fail(client::failure(kProtocol, "what comes is no message of " + channel_ + ", or one before it is missing")
             .value());
  };
  if (!number || !number->is_integer() || !data) return refuse();
  Update update;
  if (kind == "snapshot" && is_state(*data)) {
    update.state = *data;
  } else if (kind == "delta" && has_state_ && number->as_integer() == last_ + 1) {
    auto after = fold(state_, *data);
    if (!after) return refuse();
    update = {.kind = Update::Kind::delta, .state = std::move(*after), .delta = *data};
    update.delta.freeze();
  } else {
    return refuse();
  }
  update.state.freeze();
  state_ = update.state;
  last_ = number->as_integer();
  has_state_ = true;
  is_run_over_ = client::is_over(status_of(state_));
  put(std::move(update));
}

// Behind the others; if there are too many, one snapshot takes the place of all.
void CoreUpdates::put(Update update) {
  waiting_.push_back(std::move(update));
  if (waiting_.size() <= capacity_) return;
  Update all{.state = state_};
  for (const Update& each : waiting_) all.merged += std::max<std::size_t>(each.merged, 1);
  waiting_.clear();
  waiting_.push_back(std::move(all));
}

void CoreUpdates::fail(ApiError error) {
  for (Value& each : error.errors) each.freeze();
  if (!failure_) failure_ = std::move(error);
}

std::optional<Update> CoreUpdates::pop() {
  if (waiting_.empty()) return std::nullopt;
  Update next = std::move(waiting_.front());
  waiting_.pop_front();
  return next;
}

}  // namespace race::client
