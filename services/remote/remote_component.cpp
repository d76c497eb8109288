#include "services/remote/remote_component.h"

#include <utility>

#include "services/host/call_ledger.h"

namespace race::remote {

RemoteComponent::RemoteComponent(std::string key, std::shared_ptr<const rsm::Service> model,
                                 services::ServiceHost& host, HostFunctions functions)
    : key_(std::move(key)), model_(std::move(model)), host_(host), functions_(std::move(functions)) {}

void RemoteComponent::connect(std::shared_ptr<SendQueue> process, bool hears_violations) {
  process_ = std::move(process);
  hears_violations_ = hears_violations;
  if (functions_.reset) functions_.reset();
}

// If the queue is full, the connection ends, and what the process was to answer is answered `unavailable`.
Expected<void> RemoteComponent::send(const Message& message, const std::string& flow) {
  if (!process_) return {};
  ASSIGN_OR_RETURN(EncodedMessage encoded, encode(message));
  process_->push(std::move(encoded), flow);
  return {};
}

// The process gets the news of what happened before the call first.
void RemoteComponent::call(const services::Call& call) {
  notify_changes();
  Message message;
  message.kind = Kind::call;
  message.key = key_;
  message.call = call.id;
  message.name = call.operation;
  message.args = call.args;
  message.kwargs = call.kwargs;
  message.time = host_.now();
  if (auto sent = send(message); !sent)
    host_.error(call.id, services::error_value(name(sent.error().code), sent.error().message));
}

void RemoteComponent::packet(std::string_view key, std::string_view flow, const services::PacketPtr& packet) {
  Message message;
  message.kind = Kind::packet;
  message.key = key_;
  message.service = std::string(key);
  message.name = std::string(flow);
  message.time = packet->time;
  message.value = packet->header;
  message.bytes = packet->bytes;
  if (auto sent = send(message, key_ + " " + message.service + " " + message.name); !sent)
    host_.log("a packet of `" + message.service + "." + message.name + "` is lost: " + sent.error().message);
}

void RemoteComponent::demand_changed(std::string_view flow, bool on) {
  Message message;
  message.kind = Kind::wanted;
  message.key = key_;
  message.name = std::string(flow);
  message.on = on;
  message.time = host_.now();
  if (auto sent = send(message); !sent) host_.log(sent.error().message);
}

void RemoteComponent::limit_speed(std::optional<double> tool_speed) {
  Message message;
  message.kind = Kind::limit_speed;
  message.key = key_;
  if (tool_speed) message.value = *tool_speed;
  message.time = host_.now();
  if (auto sent = send(message); !sent) host_.log(sent.error().message);
}

void RemoteComponent::violated(const services::Violation& violation) {
  if (!hears_violations_) return;
  Message message;
  message.kind = Kind::violation;
  message.key = key_;
  message.name = violation.rule;
  message.value = cut(violation.message);
  message.call = violation.call;
  message.service = violation.operation;
  message.time = violation.time;
  (void)send(message);  // texts and finite numbers: it can be said
}

void RemoteComponent::notify_changes() {
  if (!functions_.version) return;
  const std::uint64_t version = functions_.version();
  if (std::exchange(notified_version_, version) == version) return;
  Message message;
  message.kind = Kind::news;
  message.key = key_;
  message.time = host_.now();
  (void)send(message);  // not as of a flow: a later one that replaced it would come after a call between them
}

Expected<void> RemoteComponent::answer(const Message& request) {
  if (!functions_.request) return unexpected(ErrorCode::not_found, "there is nothing here that it could ask", key_);
  Message reply;
  reply.kind = Kind::reply;
  reply.number = request.number;
  ASSIGN_OR_RETURN(reply.value, functions_.request(request.name, request.kwargs));
  return send(reply);
}

Expected<void> RemoteComponent::announce(Message message) {
  switch (message.kind) {
    case Kind::transition:
      host_.transition(message.name, message.call);
      break;
    case Kind::result:
      host_.result(message.call, std::move(message.value));
      break;
    case Kind::error:
      host_.error(message.call, std::move(message.value));
      break;
    case Kind::reject:
      host_.reject(message.call);
      break;
    case Kind::event:
      host_.event(message.name, std::move(message.value));
      break;
    case Kind::log:
      host_.log(std::move(message.name));
      break;
    case Kind::subscribe:
      host_.subscribe(message.service, message.name, message.on);
      break;
    case Kind::publish: {
      const std::string flow = message.name;
      host_.publish(flow, packet_of(std::move(message)));
      break;
    }
    case Kind::request:
      return answer(message);
    default:
      break;
  }
  return {};
}

}  // namespace race::remote
