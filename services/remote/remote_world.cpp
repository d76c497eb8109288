#include "services/remote/remote_world.h"

#include <optional>
#include <utility>

#include "core/value/fields.h"

namespace race::remote {
namespace {

tl::unexpected<Error> away() { return unexpected(ErrorCode::unavailable, "the process of the cell is not there"); }

std::optional<ErrorCode> code_of(std::string_view text) {
  for (int code = 0; code <= static_cast<int>(ErrorCode::not_accepted); ++code)
    if (name(static_cast<ErrorCode>(code)) == text) return static_cast<ErrorCode>(code);
  return std::nullopt;
}

// Why an act was refused, as the process says it.
Expected<Error> read_error(const Value& json) {
  std::vector<Error> errors;
  Fields fields(json, "error", "the error", errors, Fields::Paths::field);
  const auto path = fields.text("path", Fields::Need::required), code = fields.text("code", Fields::Need::required),
             text = fields.text("message", Fields::Need::required);
  fields.close();
  if (!errors.empty()) return tl::unexpected(errors.front());
  if (path->size() > kNameBytes || text->size() > kNameBytes)
    return unexpected(ErrorCode::out_of_range, "its texts have at most " + std::to_string(kNameBytes) + " bytes",
                      "error");
  const auto known = code_of(*code);
  if (!known) return unexpected(ErrorCode::out_of_range, "there is no code `" + *code + "`", "error");
  return Error{*known, *text, *path};
}

Message message_of(Kind kind) {
  Message message;
  message.kind = kind;
  return message;
}

}  // namespace

RemoteWorld::RemoteWorld(const services::Clock& clock, Door door, std::function<void(Value)> show)
    : clock_(clock), door_(std::move(door)), show_(std::move(show)) {}

// With the lock. A process that reads nothing answers no ping either, and is lost.
bool RemoteWorld::send(Message message) {
  message.time = clock_.now();
  auto frame = encode(message);
  return frame && process_->push(std::move(*frame));
}

void RemoteWorld::connect(std::shared_ptr<FrameQueue> process, Value world) {
  std::map<std::int64_t, Done> left;
  {
    const std::lock_guard lock(mutex_);
    process_ = std::move(process);
    world_ = std::move(world);
    left.swap(waiting_);
    if (process_ && watched_) {
      Message message = message_of(Kind::watch);
      message.on = true;
      send(std::move(message));
    }
  }
  for (const auto& [number, done] : left) done(away());
}

Value RemoteWorld::world() const {
  const std::lock_guard lock(mutex_);
  return world_;
}

void RemoteWorld::act(Value act, Done done) {
  {
    const std::lock_guard lock(mutex_);
    Message message = message_of(Kind::act);
    message.number = acts_ + 1;
    message.value = std::move(act);
    if (process_ && waiting_.size() < kActs && send(std::move(message))) {
      waiting_.emplace(++acts_, std::move(done));
      return;
    }
  }
  done(away());
}

void RemoteWorld::watch(bool on) {
  const std::lock_guard lock(mutex_);
  if (std::exchange(watched_, on) == on || !process_) return;
  Message message = message_of(Kind::watch);
  message.on = on;
  send(std::move(message));
}

Expected<void> RemoteWorld::announce(Message message) {
  message.value.freeze();
  return message.kind == Kind::pose ? posed(message.value) : answered(message);
}

Expected<void> RemoteWorld::posed(const Value& pose) {
  {
    const std::lock_guard lock(mutex_);
    if (!watched_) return {};  // it was on its way
  }
  if (auto good = door_.pose(world(), pose); !good) return good;
  show_(pose);
  return {};
}

// What does not fit answers nobody: the process is lost, and with it the act.
Expected<void> RemoteWorld::answered(const Message& message) {
  Expected<Value> answer = message.value;
  if (message.kind == Kind::failed) {
    ASSIGN_OR_RETURN(Error error, read_error(message.value));
    answer = tl::unexpected(std::move(error));
  } else if (auto good = door_.answer(world(), message.value); !good) {
    return good;
  }
  Done done;
  {
    const std::lock_guard lock(mutex_);
    const auto found = waiting_.find(message.number);
    if (found == waiting_.end()) return unexpected(ErrorCode::conflict, "nobody waits for this", "number");
    done = std::move(found->second);
    waiting_.erase(found);
  }
  done(std::move(answer));
  return {};
}

}  // namespace race::remote
