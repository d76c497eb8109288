// Tools of the queue: runs that wait their turn. None lets a paused queue go on, or go on after a fault: that is for a
// person who has looked (server/queue).
#include "server/mcp/tool.h"

namespace race::server::mcp {

Outcome list_queue(const Context& context, const Dict& arguments) {
  if (const Value* id = arguments.find("id")) return context.api.get(Target{"queue", id->as_string()});
  return context.api.get(Target{"queue"}.with("after", arguments.find("after")).with("limit", arguments.find("limit")));
}

Outcome queue_run(const Context& context, const Dict& arguments) {
  return context.api.post(Target{"queue"}, arguments);
}

Outcome cancel_queued_run(const Context& context, const Dict& arguments) {
  return context.api.ask("DELETE", Target{"queue", text_of(arguments, "id")});
}

}  // namespace race::server::mcp
