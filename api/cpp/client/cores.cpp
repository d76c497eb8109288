#include "api/cpp/client/cores.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "api/cpp/client/answer_internal.h"
#include "api/cpp/client/calls.h"
#include "api/cpp/client/fold.h"

namespace race::client {

Answered<Value> wait_for_end(const Client& client, std::string_view core, std::chrono::milliseconds timeout) {
  using Clock = std::chrono::steady_clock;
  const auto left = [end = Clock::now() + timeout] {
    return std::max(std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()),
                    std::chrono::milliseconds(0));
  };
  ASSIGN_OR_RETURN(Value last, client.send(calls::get_core(core)));
  ASSIGN_OR_RETURN(const std::string status, text_in(last, "status"));
  if (is_over(status)) return last;
  ASSIGN_OR_RETURN(Following updates, client.follow(core, left()));
  for (;;) {
    ASSIGN_OR_RETURN(const std::optional<Update> update, updates.next(left()));
    if (!update) return last;
    last = *update->state.find("core");
    if (is_over(status_of(update->state))) return last;
  }
}

Answered<Value> run_document(const Client& client, std::string_view document, const Value& arguments,
                             std::chrono::milliseconds timeout) {
  ASSIGN_OR_RETURN(const Value core,
                   client.send(calls::create_core(Dict{{"document", document}, {"arguments", arguments}})));
  ASSIGN_OR_RETURN(const std::string id, text_in(core, "id"));
  if (auto started = client.send(calls::start_core(id)); !started) return started;
  return wait_for_end(client, id, timeout);
}

}  // namespace race::client
