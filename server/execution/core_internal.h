// How questions and commands reach a core's strand: for the files of Core.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <type_traits>
#include <utility>

#include "server/execution/core.h"

namespace race::server {

// A question on its way to the strand: it is executed in time, or never.
template <typename T>
struct Question {
  explicit Question(Done<T> done) : answer(std::move(done)) {}
  Once<T> answer;
  std::atomic<bool> decided{false};  // it has begun, or is given up
  bool decide() { return !decided.exchange(true); }
};

// Answers who asked if the strand does not come to it, and then it is not executed any more: who asked is told that
// nothing has happened, and it is so. What has begun happens, and is answered as soon as the disk or its watch has
// answered; not even that comes while its own macro step goes on.
template <typename T>
void give_up_late(Deadlines& deadlines, const std::shared_ptr<Question<T>>& question, const std::string& core) {
  constexpr std::chrono::seconds kTimeout{5};
  deadlines.after(kTimeout, [weak = std::weak_ptr(question), core, &deadlines] {
    const auto late = weak.lock();
    if (!late) return;
    if (late->decide()) return late->answer(unexpected(ErrorCode::unavailable, "core " + core + " is busy"));
    deadlines.after(2 * DiskWatch::kTimeout, [weak, core] {
      if (const auto begun = weak.lock())
        begun->answer(unexpected(ErrorCode::unavailable, "core " + core + " has begun this, and is busy"));
    });
  });
}

template <typename T>
std::size_t units_of(const Expected<T>& answer) {
  if constexpr (std::is_same_v<T, Value>) return answer ? answer->size_units() : 0;
  return 0;
}

// Posts `function` and gives `done` its value when all that caused it is durable, or never will be. What services have
// said before is among the inputs of the run by then.
template <typename T, typename F>
void Core::on_strand(Done<T> done, F function) {
  auto question = std::make_shared<Question<T>>(std::move(done));
  give_up_late(resources_.deadlines, question, id_);
  strand_.post([self = shared_from_this(), function = std::move(function), question = std::move(question)] {
    if (!question->decide()) return;
    const Measurement measurement(self->computing_);
    try {
      self->take_inbox();
      auto value = Expected<T>(function());
      self->tell_untold();
      const std::size_t units = units_of(value);
      self->held_.add(
          [question, value = std::move(value)](const Error* failure) {
            question->answer(failure ? Expected<T>(tl::unexpect, *failure) : value);
          },
          units, true);
      self->say_due();
    } catch (const std::exception& failure) {
      self->interrupt_after(failure);
      question->answer(unexpected(ErrorCode::unavailable, std::string("this failed: ") + failure.what()));
    }
  });
}

// The same, once a run that is interrupted is as its journal says.
template <typename T, typename F>
void Core::when_rebuilt(Done<T> done, F function) {
  ensure_rebuilt(
      [self = shared_from_this(), done = std::move(done), function = std::move(function)](const Expected<void>& ready) {
        if (!ready) return done(tl::unexpected(ready.error()));
        self->on_strand<T>(done, function);
      });
}

}  // namespace race::server
