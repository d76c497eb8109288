#include "server/execution/past_json.h"

#include <utility>

#include "services/sqlite/digest.h"

namespace race::server {

Expected<Value> past_json(execution::Replay& replay, std::uint64_t step, int micro, const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(execution::Past past, execution::past(replay, step, micro, stop));
  past.json.set("digest", sqlite::hex(sqlite::sha256(past.text)));
  return Value(std::move(past.json));
}

}  // namespace race::server
