#include "server/mcp/batch.h"

namespace race::server::mcp {

void Batch::add(std::optional<Value> response) {
  List whole;
  {
    const services::MutexLock lock(mutex_);
    if (response) responses_.push_back(std::move(response->freeze()));
    if (--waiting_ > 0) return;
    whole.swap(responses_);
  }
  if (!whole.empty()) send_(std::move(whole));
}

}  // namespace race::server::mcp
