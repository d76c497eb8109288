#include "server/http/answer.h"

#include <utility>

#include "server/http/refusal.h"
#include "services/failures.h"

namespace race::server {

struct Answer::Delivery {
  explicit Delivery(std::function<void(Reply)> its_deliver) : deliver(std::move(its_deliver)) {}
  Delivery(const Delivery&) = delete;
  ~Delivery() {
    if (!replied)
      services::run_reporting("an answer", [this] {
        deliver(refusal(503, std::vector<Error>{{ErrorCode::unavailable, "the server could not answer; ask again"}}));
      });
  }

  const std::function<void(Reply)> deliver;
  std::atomic<bool> replied{false};
};

Answer::Answer(std::function<void(Reply)> deliver) : delivery_(std::make_shared<Delivery>(std::move(deliver))) {}

void Answer::operator()(Reply reply) const {
  if (delivery_->replied.exchange(true)) return;
  try {
    delivery_->deliver(std::move(reply));
  } catch (...) {
    delivery_->replied = false;
    throw;
  }
}

}  // namespace race::server
