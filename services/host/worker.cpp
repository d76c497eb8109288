#include "services/host/worker.h"

#include <exception>

namespace race::services {

void Worker::submit(Time at, std::function<Answer()> heavy) {
  thread_.post([this, reservation = host_.reserve(at), heavy = std::move(heavy)] {
    Answer answer;
    try {
      answer = heavy();
    } catch (...) {
      answer = [failure = std::current_exception()] { std::rethrow_exception(failure); };
    }
    host_.fulfil(reservation, std::move(answer));
  });
}

}  // namespace race::services
