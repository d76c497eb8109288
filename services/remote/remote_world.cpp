#include "services/remote/remote_world.h"

#include <utility>

#include "core/value/fields.h"

namespace race::remote {
namespace {

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

tl::unexpected<Error> no_such_command() { return unexpected(ErrorCode::conflict, "nobody waits for this", "number"); }

Message message_of(Kind kind) {
  Message message;
  message.kind = kind;
  return message;
}

}  // namespace

tl::unexpected<Error> no_world() { return unexpected(ErrorCode::unavailable, "the process of the cell is not there"); }

RemoteWorld::RemoteWorld(const services::Clock& clock, Validator validate, std::function<void(Value)> show)
    : clock_(clock), validate_(std::move(validate)), show_(std::move(show)) {}

Expected<RemoteWorld::World> RemoteWorld::check(Value world) const {
  world.freeze();
  ASSIGN_OR_RETURN(Rules rules, validate_(world));
  return World{std::move(world), std::move(rules)};
}

// A process that reads nothing answers no ping either, and is disconnected.
Expected<void> RemoteWorld::send(Message message) {
  message.time = clock_.now();
  ASSIGN_OR_RETURN(EncodedMessage encoded, encode(message));
  if (!process_->push(std::move(encoded)))
    return unexpected(ErrorCode::unavailable, "the process of the cell takes nothing more");
  return {};
}

void RemoteWorld::connect(std::shared_ptr<SendQueue> process, World world) {
  std::map<std::int64_t, Command> left;
  {
    const services::MutexLock lock(mutex_);
    world_ = process ? std::make_shared<const World>(std::move(world)) : nullptr;
    process_ = std::move(process);
    left.swap(pending_);
    if (process_ && watched_) {
      Message message = message_of(Kind::watch);
      message.on = true;
      (void)send(std::move(message));
    }
  }
  for (const auto& [number, command] : left) command.done(no_world());
}

Value RemoteWorld::world() const {
  const services::MutexLock lock(mutex_);
  return world_ ? world_->value : Value();
}

// Takes the command if it waits from now on.
Expected<void> RemoteWorld::offer(Command& command) {
  if (!process_) return no_world();
  if (pending_.size() >= kMaxPendingCommands)
    return unexpected(ErrorCode::unavailable, std::to_string(kMaxPendingCommands) + " acts wait for the cell already");
  Message message = message_of(Kind::offer);
  message.number = last_number_ + 1;
  if (auto sent = send(std::move(message)); !sent) return sent;
  pending_.emplace(++last_number_, std::move(command));
  return {};
}

void RemoteWorld::execute(Value what, Confirm confirm, Done done) {
  what.freeze();
  Command command{std::move(what), std::move(confirm), std::move(done)};
  Expected<void> offered;
  {
    const services::MutexLock lock(mutex_);
    offered = offer(command);
  }
  if (!offered) command.done(tl::unexpected(std::move(offered).error()));
}

// If the caller has given up meanwhile, it got its answer already: the command is dropped.
Expected<void> RemoteWorld::handle_ready(std::int64_t number) {
  Done done;
  Expected<void> sent;
  {
    const services::MutexLock lock(mutex_);
    const auto found = pending_.find(number);
    if (found == pending_.end() || found->second.sent) return no_such_command();
    if (found->second.confirm()) {
      Message message = message_of(Kind::act);
      message.number = number;
      message.value = found->second.what;
      sent = send(std::move(message));
      if (sent) {
        found->second.sent = true;
        return {};
      }
      done = std::move(found->second.done);
    }
    pending_.erase(found);
  }
  if (done) done(tl::unexpected(std::move(sent).error()));
  return {};
}

void RemoteWorld::watch(bool on) {
  const services::MutexLock lock(mutex_);
  if (std::exchange(watched_, on) == on || !process_) return;
  Message message = message_of(Kind::watch);
  message.on = on;
  (void)send(std::move(message));
}

Expected<void> RemoteWorld::announce(Message message) {
  if (message.kind == Kind::ready) return handle_ready(message.number);
  message.value.freeze();
  return message.kind == Kind::pose ? handle_pose(message.value) : handle_answer(message);
}

Expected<void> RemoteWorld::handle_pose(const Value& pose) {
  std::shared_ptr<const World> world;
  {
    const services::MutexLock lock(mutex_);
    if (!watched_ || !world_) return {};  // it was sent before watching ended
    world = world_;
  }
  if (auto good = world->rules.pose(pose); !good) return good;
  show_(pose);
  return {};
}

// An invalid answer disconnects the process, and thereby answers the command `unavailable`.
Expected<void> RemoteWorld::handle_answer(const Message& message) {
  Done done;
  Expected<Value> answer = message.value;
  {
    const services::MutexLock lock(mutex_);
    const auto found = pending_.find(message.number);
    if (found == pending_.end() || !found->second.sent) return no_such_command();
    if (message.kind == Kind::failed) {
      ASSIGN_OR_RETURN(Error error, read_error(message.value));
      answer = tl::unexpected(std::move(error));
    } else if (auto good = world_->rules.answer(message.value); !good) {
      return good;
    }
    done = std::move(found->second.done);
    pending_.erase(found);
  }
  done(std::move(answer));
  return {};
}

}  // namespace race::remote
