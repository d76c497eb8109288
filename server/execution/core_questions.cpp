// Questions about a core: answered with what is durable; those about the past by a replay of the journal, on the thread
// of replays.
#include <algorithm>

#include "core/execution/step_json.h"
#include "server/execution/core_internal.h"
#include "server/execution/past_json.h"

namespace race::server {

void Core::state(Done<Value> done) {
  on_strand<Value>(std::move(done), [this]() -> Expected<Value> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    Value state = Dict{{"core", info_json()}, {"state", run().state_json()}};
    return state.freeze();
  });
}

void Core::why(execution::WhyQuestion question, Done<Value> done) {
  on_strand<Value>(std::move(done), [this, question = std::move(question)]() -> Expected<Value> {
    ASSIGN_OR_RETURN(const semantics::Subject subject, execution::find_subject(program(), question));
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    Value why = why_json(execution_, subject);
    return why.freeze();
  });
}

// `function` of the replay, on the thread of replays. Whole macro steps that it has done are kept, so that it is faster
// when it is asked again.
template <typename F>
void Core::replayed(SharedStop gone, Done<Value> done, F function) {
  resources_.replays.ask<Value>(
      [replay = replay_, function = std::move(function)](const Stop& stop) -> Expected<Value> {
        ASSIGN_OR_RETURN(Value json, function(*replay, &stop));
        return json.freeze();
      },
      {kReplayTimeout, {ErrorCode::unavailable, "the replay takes long, ask again"}}, std::move(gone), std::move(done));
}

Core::Reached Core::reached_now() const {
  static const Value kRunning = [] {
    Value running = Dict{{"status", semantics::name(semantics::Status::running)}};
    return running.freeze();
  }();
  Reached reached{run().position(), execution_.is_open() ? static_cast<int>(execution_.micro()) : -1, kRunning};
  if (!is_over()) return reached;
  Dict status;
  execution::set_status(run(), status);
  reached.status = std::move(status);
  reached.status.freeze();
  return reached;
}

Expected<Core::Reached> Core::reached() const {
  const services::MutexLock lock(mutex_);
  return reached_;
}

void Core::set_reached(Expected<Reached> reached) {
  const services::MutexLock lock(mutex_);
  reached_ = std::move(reached);
}

// `micro`, as far as what was told last goes.
Expected<int> Core::told_micro(std::uint64_t step, int micro) const {
  ASSIGN_OR_RETURN(const Reached now, reached());
  if (step < 1 || step > now.step)
    return unexpected(ErrorCode::out_of_range, "there are macro steps 1 to " + std::to_string(now.step), "step");
  return step == now.step && now.micro >= 0 ? std::min(micro, now.micro) : micro;
}

void Core::past(std::uint64_t step, int micro, SharedStop gone, Done<Value> done) {
  const Expected<int> told = told_micro(step, micro);
  if (!told) return done(tl::unexpected(told.error()));
  replayed(
      std::move(gone), std::move(done),
      [self = shared_from_this(), step, micro = *told](execution::Replay& replay, const Stop* stop) -> Expected<Value> {
        return past_json(replay, step, micro, {self->resources_.runs, self->run_id_, self->timing()}, stop);
      });
}

void Core::why_before(execution::WhyQuestion question, std::size_t step, int micro, SharedStop gone, Done<Value> done) {
  const Expected<int> told = told_micro(step, micro);
  if (!told) return done(tl::unexpected(told.error()));
  replayed(std::move(gone), std::move(done),
           [step, micro = *told, question = std::move(question)](execution::Replay& replay, const Stop* stop) {
             return execution::why_before(replay, question, step, micro, stop);
           });
}

Expected<std::uint64_t> Core::position() const {
  ASSIGN_OR_RETURN(const Reached now, reached());
  return now.step;
}

void Core::derivations(std::size_t from, std::size_t to, SharedStop gone, Done<Value> done) {
  Expected<Reached> now = reached();
  if (!now) return done(tl::unexpected(std::move(now).error()));
  if (from == 0) from = now->step;
  if (to == 0) to = from;
  if (now->step > 0 && (from > to || to > now->step || to - from >= 100))
    return done(unexpected(ErrorCode::out_of_range,
                           "macro steps 1 to " + std::to_string(now->step) + " can be had, at most 100 at once"));
  replayed(std::move(gone), std::move(done),
           [from, to, now = std::move(*now)](execution::Replay& replay, const Stop* stop) -> Expected<Value> {
             Dict json = now.status.as_dict();
             List steps;
             if (now.step > 0) {
               ASSIGN_OR_RETURN(steps, replay.steps(from, to, now.step, now.micro, stop));
             }
             json.set("steps", std::move(steps));
             return Value(std::move(json));
           });
}

}  // namespace race::server
