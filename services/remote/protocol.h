// The protocol between the server and a process of components (api/schemas/component_request.json and
// component_message.json): what a component and its ServiceHost say to each other, as WebSocket messages. One codec for
// both ends; invalid messages are errors. Pure functions.
//
// A message is a JSON object with its `type`. A packet of a data flow is a binary message: the length of its JSON as
// four bytes, the highest first, the JSON, and the packet's bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/value/expected.h"
#include "services/component.h"
#include "services/remote/send_queue.h"

namespace race::remote {

/// Of the messages below; an end that speaks another is refused.
inline constexpr std::int64_t kProtocol = 1;
/// Of one message: a value of the database in its message, or a packet.
inline constexpr std::size_t kMessageBytes = 32 * 1024 * 1024;
/// Of the JSON of a packet: its header is shown to everyone who watches services.
inline constexpr std::size_t kHeaderBytes = 64 * 1024;
/// Of keys and names, logs, and the texts of errors.
inline constexpr std::size_t kNameBytes = 1000;

enum class Kind : std::uint8_t {
  // to the server
  hello,       // first: what the process brings
  transition,  // the functions of ServiceHost
  result,
  error,
  reject,
  event,
  log,
  subscribe,
  publish,  // a packet
  request,  // a call of a host function (host_functions.h)
  pose,     // of the world (remote_world.h): where everything is
  ready,    // for the command that was offered
  done,     // the answer to the command
  failed,   // why the command was refused
  pong,     // the group's thread has got the ping
  // to the process; most have the server's time
  welcome,  // its components are connected
  refused,  // they are not, and why; the connection ends
  call,     // the functions of Component
  wanted,   // demand_changed()
  limit_speed,
  packet,
  reply,  // to a request
  news,   // replies to earlier requests may be out of date
  offer,  // of a command in the world; sent once the process is ready
  act,    // the command
  watch,  // whether to send poses
  ping,
  violation,  // what the process announced does not fit the RSM of a service
};

/// Who reads a message.
enum class Reader : std::uint8_t { server, process };

/// Its `type`.
std::string_view name(Kind kind);
Reader reader_of(Kind kind);

/// Any message; what its kind does not have is empty. Values are unfrozen: they belong to the thread that decoded, or
/// to the one that the whole message is moved to.
struct Message {
  Kind kind = Kind::pong;
  std::string key;            // of the component that speaks or is spoken to
  std::string name;           // of the transition, operation, event, flow, function or rule; the text of a log
  std::string service;        // whose flow it is; of a violation, the operation of its call
  services::CallId call = 0;  // 0: no call
  std::int64_t number = 0;    // of the protocol, of a ping, of a request, of a command; the heartbeat [ms]
  bool on = false;            // subscribes, has subscribers, is watched, wants to be told of violations
  services::Time time = 0;    // the server's; of a packet, its own
  Value value;  // result, error, reply, data of an event, header of a packet, components, errors, act, pose, tool
                // speed, what a violation is
  Value world;  // that the process brings, or null
  List args;
  Dict kwargs;
  std::vector<std::byte> bytes;  // of a packet
};

/// Errors: `too_large` (more than kMessageBytes), `constant` (NaN or an infinity).
Expected<EncodedMessage> encode(const Message& message);

/// Errors, with the field as path: `json`, `too_deep`, `too_large`, `constant` (no JSON within its limits), `type`
/// (also: no type of a message for this reader, text where bytes are due or the other way round), `missing`,
/// `unknown_field`, `out_of_range`.
Expected<Message> decode(const EncodedMessage& encoded, Reader reader);

/// A text as it may be said: at most kNameBytes of it, cut between characters.
std::string cut(std::string text);

/// {path, code, message}, as messages say it, both texts cut.
Value error_json(const Error& error);

/// The limit of a `limit_speed` [m/s]; nothing: none.
std::optional<double> tool_speed_of(const Message& message);

/// The service's packet of a message, frozen.
services::PacketPtr packet_of(Message message);

}  // namespace race::remote
