// Questions about a core: answered with what is durable; those about the past by a replay of the journal, on the thread
// of replays.
#include <algorithm>

#include "core/execution/step_json.h"
#include "core/execution/why.h"
#include "server/execution/core_internal.h"

namespace race::server {

Expected<Value> Core::state() {
  return on_strand<Value>([this]() -> Expected<Value> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    Value state = Dict{{"core", info_json()}, {"state", run().state_json()}};
    return state.freeze();
  });
}

Expected<Value> Core::why(const std::string& port) {
  return on_strand<Value>([this, port]() -> Expected<Value> {
    const auto id = program().find_port(port);
    if (!id) return unexpected(ErrorCode::not_found, "there is no port of this path", port);
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    Value why = why_json(execution_, *id);
    return why.freeze();
  });
}

// `function` of the replay, on the thread of replays. It goes on when nobody waits any more: what it has done is kept,
// so that it is faster when it is asked again.
template <typename F>
Expected<Value> Core::replayed(F function) {
  auto answer = resources_.replays.ask(
      [replay = replay_, function = std::move(function)](const Worker::Stop&) -> Expected<Value> {
        ASSIGN_OR_RETURN(Value json, function(*replay));
        return json.freeze();
      },
      kReplayTimeout);
  if (answer) return std::move(*answer);
  if (answer.error().code == ErrorCode::unavailable) return tl::unexpected(std::move(answer).error());
  return unexpected(ErrorCode::unavailable, "the replay takes long, ask again");
}

Expected<Core::Reached> Core::reached() {
  return on_strand<Reached>([this]() -> Expected<Reached> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    Reached reached{run().position(), execution_.is_open() ? static_cast<int>(execution_.micro()) : -1, {}};
    execution::set_status(run(), reached.status);
    return reached;
  });
}

Expected<Value> Core::why_before(const std::string& port, std::size_t step, int micro) {
  ASSIGN_OR_RETURN(const Reached now, reached());
  if (step < 1 || step > now.step)
    return unexpected(ErrorCode::out_of_range, "there are macro steps 1 to " + std::to_string(now.step), "step");
  const int done = step == now.step && now.micro >= 0 ? std::min(micro, now.micro) : micro;
  return replayed([step, done, port](execution::Replay& replay) -> Expected<Value> {
    ASSIGN_OR_RETURN(execution::Execution past, replay.before(step, done));
    const auto id = past.run().program().find_port(port);
    if (!id) return unexpected(ErrorCode::not_found, "there was no port of this path", port);
    return why_json(past, *id);
  });
}

Expected<std::uint64_t> Core::position() {
  ASSIGN_OR_RETURN(const Reached now, reached());
  return now.step;
}

Expected<Value> Core::derivations(std::size_t from, std::size_t to) {
  ASSIGN_OR_RETURN(Reached now, reached());
  if (from == 0) from = now.step;
  if (to == 0) to = from;
  if (now.step > 0 && (from > to || to > now.step || to - from >= 100))
    return unexpected(ErrorCode::out_of_range,
                      "macro steps 1 to " + std::to_string(now.step) + " can be had, at most 100 at once");
  Dict json = std::move(now.status);
  ASSIGN_OR_RETURN(Value derived, replayed([from, to, last = now.step,
                                            micro = now.micro](execution::Replay& replay) -> Expected<Value> {
                     if (last == 0) return List();
                     return replay.steps(from, to, last, micro);
                   }));
  json.set("steps", std::move(derived));
  return Value(std::move(json));
}

}  // namespace race::server
