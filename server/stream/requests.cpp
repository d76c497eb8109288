#include "server/stream/requests.h"

#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::server {
namespace {

struct StreamRequest {
  bool subscribe = true;
  std::string channel;
  std::optional<std::int64_t> since;
};

Checked<StreamRequest> read(std::string_view message) {
  auto json = parse_json(message);
  if (!json) return tl::unexpected(std::vector<Error>{std::move(json).error()});
  std::vector<Error> errors;
  Fields fields(*json, "", "the message", errors, Fields::Paths::field);
  StreamRequest request;
  const std::string type = fields.text("type", Fields::Need::required).value_or("");
  request.subscribe = type == "subscribe";
  if (!request.subscribe && type != "unsubscribe")
    fields.violation(ErrorCode::type, "`type` must be `subscribe` or `unsubscribe`", "type");
  request.channel = fields.text("channel", Fields::Need::required).value_or("");
  const Value* since = request.subscribe ? fields.find("since") : nullptr;
  if (since && !since->is_integer()) fields.violation(ErrorCode::type, "`since` must be a sequence number", "since");
  if (since && since->is_integer()) request.since = since->as_integer();
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return request;
}

}  // namespace

void handle_stream_request(std::string_view message, const std::shared_ptr<Listener>& listener, Hub& hub) {
  auto request = read(message);
  if (!request) return hub.refuse(listener, "", std::move(request).error());
  if (request->subscribe) {
    hub.subscribe(listener, std::move(request->channel), request->since);
  } else {
    hub.unsubscribe(listener, std::move(request->channel));
  }
}

}  // namespace race::server
