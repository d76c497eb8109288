#include "server/handlers/channel_events.h"

#include <optional>
#include <utility>

#include "server/accounts/rights.h"
#include "server/handlers/query.h"

namespace race::server {
namespace {

constexpr std::string_view kLastEvent = "last-event-id";

// Nothing: the client has none yet.
Expected<std::optional<std::int64_t>> last_event(const Request& request) {
  if (request.count(kLastEvent) == 0) return std::nullopt;
  const auto number = whole_number(request.header(kLastEvent));
  if (request.count(kLastEvent) == 1 && number) return number;
  return unexpected(ErrorCode::out_of_range, "must be the id of an event", "Last-Event-ID");
}

}  // namespace

Handled channel_events(const Request& request, std::string channel) {
  if (auto may = check_channel(request.identity, channel); !may) return failed(std::move(may).error());
  const auto since = last_event(request);
  if (!since) return failed(since.error());
  Reply reply;
  reply.type = "text/event-stream";
  reply.headers.emplace_back("Cache-Control", "no-store");
  reply.events = ChannelEvents{std::move(channel), *since};
  return reply;
}

}  // namespace race::server
