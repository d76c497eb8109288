#include "services/remote/remote_component.h"

namespace race::remote {

RemoteComponent::RemoteComponent(std::string key, const rsm::Service& model, services::ServiceHost& host)
    : key_(std::move(key)), model_(model), host_(host) {}

// A process that reads nothing loses what is sent; it answers no ping either, and is lost itself.
Expected<void> RemoteComponent::send(const Message& message, const std::string& flow) {
  if (!process_) return {};
  ASSIGN_OR_RETURN(Frame frame, encode(message));
  process_->push(std::move(frame), flow);
  return {};
}

void RemoteComponent::call(const services::Call& call) {
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

void RemoteComponent::wanted(std::string_view flow, bool on) {
  Message message;
  message.kind = Kind::wanted;
  message.key = key_;
  message.name = std::string(flow);
  message.on = on;
  message.time = host_.now();
  if (auto sent = send(message); !sent) host_.log(sent.error().message);
}

void RemoteComponent::announce(Message message) {
  switch (message.kind) {
    case Kind::transition:
      return host_.transition(message.name, message.call);
    case Kind::result:
      return host_.result(message.call, std::move(message.value));
    case Kind::error:
      return host_.error(message.call, std::move(message.value));
    case Kind::reject:
      return host_.reject(message.call);
    case Kind::event:
      return host_.event(message.name, std::move(message.value));
    case Kind::log:
      return host_.log(std::move(message.name));
    case Kind::subscribe:
      return host_.subscribe(message.service, message.name, message.on);
    case Kind::publish: {
      const std::string flow = message.name;
      return host_.publish(flow, packet_of(std::move(message)));
    }
    default:
      return;
  }
}

}  // namespace race::remote
