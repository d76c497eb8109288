#include "services/remote/protocol.h"

#include <array>
#include <cmath>
#include <span>
#include <variant>

#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::remote {
namespace {

using Member =
    std::variant<std::string Message::*, services::CallId Message::*, std::int64_t Message::*, bool Message::*,
                 services::Time Message::*, Value Message::*, List Message::*, Dict Message::*>;

struct Field {
  const char* name;
  Member member;
  bool optional = false;  // absent: as in a Message without it
};

constexpr Field kKey{"key", &Message::key};
constexpr Field kCall{"call", &Message::call};
constexpr Field kTime{"time", &Message::time};
constexpr Field kOn{"on", &Message::on};
constexpr Field kFlow{"flow", &Message::name};
constexpr Field kService{"service", &Message::service};
constexpr Field kHeader{"header", &Message::value};

constexpr Field kNumber{"number", &Message::number};

constexpr std::array kHello = {Field{"protocol", &Message::number}, Field{"components", &Message::value},
                               Field{"world", &Message::world, true}, Field{"violations", &Message::on, true}};
constexpr std::array kTransition = {kKey, Field{"id", &Message::name}, Field{"call", &Message::call, true}};
constexpr std::array kResult = {kKey, kCall, Field{"value", &Message::value}};
constexpr std::array kError = {kKey, kCall, Field{"error", &Message::value}};
constexpr std::array kReject = {kKey, kCall};
constexpr std::array kEvent = {kKey, Field{"name", &Message::name}, Field{"data", &Message::value}};
constexpr std::array kLog = {kKey, Field{"text", &Message::name}};
constexpr std::array kSubscribe = {kKey, kService, kFlow, kOn};
constexpr std::array kPublish = {kKey, kFlow, kTime, kHeader};
constexpr std::array kRequest = {kKey, kNumber, Field{"function", &Message::name},
                                 Field{"arguments", &Message::kwargs}};
constexpr std::array kPose = {Field{"pose", &Message::value}};
constexpr std::array kReady = {kNumber};
constexpr std::array kDone = {kNumber, Field{"person", &Message::value}};
constexpr std::array kFailed = {kNumber, Field{"error", &Message::value}};
constexpr std::array kPong = {kNumber};
constexpr std::array kWelcome = {kTime, Field{"heartbeat", &Message::number, true}};
constexpr std::array kRefused = {Field{"errors", &Message::value}};
constexpr std::array kCalled = {
    kKey, kCall, Field{"operation", &Message::name}, Field{"args", &Message::args}, Field{"kwargs", &Message::kwargs},
    kTime};
constexpr std::array kWanted = {kKey, kFlow, kOn, kTime};
constexpr std::array kLimitSpeed = {kKey, Field{"tool_speed", &Message::value}, kTime};
constexpr std::array kPacket = {kKey, kService, kFlow, kTime, kHeader};
constexpr std::array kReply = {kNumber, Field{"value", &Message::value}};
constexpr std::array kNews = {kKey, kTime};
constexpr std::array kOffer = {kNumber, kTime};
constexpr std::array kAct = {kNumber, Field{"act", &Message::value}, kTime};
constexpr std::array kWatch = {kOn, kTime};
constexpr std::array kPing = {kNumber, kTime};
constexpr std::array kViolation = {kKey,  Field{"rule", &Message::name},         Field{"message", &Message::value},
                                   kCall, Field{"operation", &Message::service}, kTime};

struct Row {
  Kind kind;
  std::string_view name;
  Reader reader;
  std::span<const Field> fields;
  bool binary = false;
};

constexpr std::array kRows = {
    Row{Kind::hello, "hello", Reader::server, kHello},
    Row{Kind::transition, "transition", Reader::server, kTransition},
    Row{Kind::result, "result", Reader::server, kResult},
    Row{Kind::error, "error", Reader::server, kError},
    Row{Kind::reject, "reject", Reader::server, kReject},
    Row{Kind::event, "event", Reader::server, kEvent},
    Row{Kind::log, "log", Reader::server, kLog},
    Row{Kind::subscribe, "subscribe", Reader::server, kSubscribe},
    Row{Kind::publish, "publish", Reader::server, kPublish, true},
    Row{Kind::request, "request", Reader::server, kRequest},
    Row{Kind::pose, "pose", Reader::server, kPose},
    Row{Kind::ready, "ready", Reader::server, kReady},
    Row{Kind::done, "done", Reader::server, kDone},
    Row{Kind::failed, "failed", Reader::server, kFailed},
    Row{Kind::pong, "pong", Reader::server, kPong},
    Row{Kind::welcome, "welcome", Reader::process, kWelcome},
    Row{Kind::refused, "refused", Reader::process, kRefused},
    Row{Kind::call, "call", Reader::process, kCalled},
    Row{Kind::wanted, "wanted", Reader::process, kWanted},
    Row{Kind::limit_speed, "limit_speed", Reader::process, kLimitSpeed},
    Row{Kind::packet, "packet", Reader::process, kPacket, true},
    Row{Kind::reply, "reply", Reader::process, kReply},
    Row{Kind::news, "news", Reader::process, kNews},
    Row{Kind::offer, "offer", Reader::process, kOffer},
    Row{Kind::act, "act", Reader::process, kAct},
    Row{Kind::watch, "watch", Reader::process, kWatch},
    Row{Kind::ping, "ping", Reader::process, kPing},
    Row{Kind::violation, "violation", Reader::process, kViolation},
};

const Row& row_of(Kind kind) { return kRows[static_cast<std::size_t>(kind)]; }

// ---- Each type of field in and out.

Value write(const std::string& text) { return text; }
Value write(services::CallId call) { return static_cast<std::int64_t>(call); }
Value write(std::int64_t number) { return number; }
Value write(bool on) { return on; }
Value write(services::Time time) { return time; }
Value write(const Value& value) { return value; }
Value write(const List& list) { return list; }
Value write(const Dict& dict) { return dict; }

tl::unexpected<Error> wrong_type(std::string_view expected, const Value& value) {
  return unexpected(ErrorCode::type, "must be " + std::string(expected) + ", got " + std::string(kind_name(value)));
}

Expected<void> read(const Value& value, std::string& out) {
  if (!value.is_string()) return wrong_type("a string", value);
  if (value.as_string().size() > kNameBytes)
    return unexpected(ErrorCode::out_of_range, "has at most " + std::to_string(kNameBytes) + " bytes");
  out = value.as_string();
  return {};
}

Expected<void> read(const Value& value, std::int64_t& out) {
  if (!value.is_integer()) return wrong_type("an integer", value);
  if (value.as_integer() < 0) return unexpected(ErrorCode::out_of_range, "must not be negative");
  out = value.as_integer();
  return {};
}

Expected<void> read(const Value& value, services::CallId& out) {
  std::int64_t number = 0;
  if (auto good = read(value, number); !good) return good;
  out = static_cast<services::CallId>(number);
  return {};
}

Expected<void> read(const Value& value, bool& out) {
  if (!value.is_bool()) return wrong_type("a boolean", value);
  out = value.as_bool();
  return {};
}

Expected<void> read(const Value& value, services::Time& out) {
  if (!value.is_numeric()) return wrong_type("a number", value);
  out = value.to_double();
  return {};
}

Expected<void> read(const Value& value, Value& out) {
  out = value;
  return {};
}

Expected<void> read(const Value& value, List& out) {
  if (!value.is_list()) return wrong_type("a list", value);
  out = value.as_list();
  return {};
}

Expected<void> read(const Value& value, Dict& out) {
  if (!value.is_dict()) return wrong_type("an object", value);
  out = value.as_dict();
  return {};
}

// ---- Rules that one field alone does not show.

Expected<void> check(const Message& message) {
  if (message.kind == Kind::error) {
    const Value* code = message.value.find("code");
    if (!code || !code->is_string())
      return unexpected(ErrorCode::type, "must be an object with a string `code`", "error");
  }
  if ((message.kind == Kind::hello || message.kind == Kind::refused) && !message.value.is_list())
    return unexpected(ErrorCode::type, "must be a list", message.kind == Kind::hello ? "components" : "errors");
  if (message.kind == Kind::violation && !message.value.is_string())
    return unexpected(ErrorCode::type, "must be a string", "message");
  if (message.kind == Kind::limit_speed && !message.value.is_null()) {
    if (!message.value.is_numeric()) return unexpected(ErrorCode::type, "must be a number or null", "tool_speed");
    if (!(message.value.to_double() >= 0))
      return unexpected(ErrorCode::out_of_range, "must not be negative", "tool_speed");
  }
  return {};
}

Expected<Message> read_message(const Value& json, Reader reader, bool binary) {
  const Value* type = json.find("type");
  if (!json.is_dict() || !type || !type->is_string())
    return unexpected(ErrorCode::type, "a message is an object with a `type`", "type");
  const Row* row = nullptr;
  for (const Row& each : kRows)
    if (each.name == type->as_string() && each.reader == reader && each.binary == binary) row = &each;
  if (!row)
    return unexpected(ErrorCode::type,
                      "there is no such " + std::string(binary ? "binary" : "text") + " message in this direction",
                      "type");
  Message message;
  message.kind = row->kind;
  std::size_t known = 1;
  for (const Field& field : row->fields) {
    const Value* value = json.find(field.name);
    if (!value && field.optional) continue;
    if (!value) return unexpected(ErrorCode::missing, "the message needs it", field.name);
    ++known;
    auto good = std::visit([&](auto member) { return read(*value, message.*member); }, field.member);
    if (!good) return unexpected(good.error().code, good.error().message, field.name);
  }
  if (known != json.as_dict().size())
    return unexpected(ErrorCode::unknown_field, "there is a field that `" + std::string(row->name) + "` has not");
  if (auto good = check(message); !good) return tl::unexpected(std::move(good).error());
  return message;
}

// Deeper than the values of a model may be, as they stand within the message.
constexpr JsonLimits kLimits{72, kMessageBytes};

std::string too_long_a_header() {
  return "the JSON of a binary message has at most " + std::to_string(kHeaderBytes) + " bytes";
}

constexpr std::size_t kLengthBytes = 4;

}  // namespace

std::string_view name(Kind kind) { return row_of(kind).name; }
Reader reader_of(Kind kind) { return row_of(kind).reader; }

Expected<EncodedMessage> encode(const Message& message) {
  const Row& row = row_of(message.kind);
  Dict json{{"type", row.name}};
  for (const Field& field : row.fields)
    std::visit([&](auto member) { json.set(field.name, write(message.*member)); }, field.member);
  const Value whole = std::move(json);
  if (!whole.is_finite()) return unexpected(ErrorCode::constant, "a message has finite numbers only");
  EncodedMessage encoded{to_json(whole), row.binary};
  if (row.binary) {
    const std::size_t length = encoded.bytes.size();
    if (length > kHeaderBytes) return unexpected(ErrorCode::too_large, too_long_a_header());
    std::string head;
    for (int shift = 24; shift >= 0; shift -= 8) head += static_cast<char>(length >> shift & 0xFFU);
    encoded.bytes.insert(0, head);
    encoded.bytes.append(reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size());
  }
  if (encoded.bytes.size() > kMessageBytes)
    return unexpected(ErrorCode::too_large, "a message has at most " + std::to_string(kMessageBytes) + " bytes");
  return encoded;
}

Expected<Message> decode(const EncodedMessage& encoded, Reader reader) {
  std::string_view text = encoded.bytes, bytes;
  if (text.size() > kMessageBytes)
    return unexpected(ErrorCode::too_large, "a message has at most " + std::to_string(kMessageBytes) + " bytes");
  if (encoded.binary) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < kLengthBytes && i < text.size(); ++i)
      length = length << 8U | static_cast<unsigned char>(text[i]);
    if (text.size() < kLengthBytes || length > text.size() - kLengthBytes)
      return unexpected(ErrorCode::out_of_range, "a binary message begins with the length of its JSON");
    if (length > kHeaderBytes) return unexpected(ErrorCode::too_large, too_long_a_header());
    bytes = text.substr(kLengthBytes + length);
    text = text.substr(kLengthBytes, length);
  }
  ASSIGN_OR_RETURN(const Value json, parse_json(text, kLimits));
  ASSIGN_OR_RETURN(Message message, read_message(json, reader, encoded.binary));
  const auto* data = reinterpret_cast<const std::byte*>(bytes.data());
  message.bytes.assign(data, data + bytes.size());
  return message;
}

std::string cut(std::string text) {
  if (text.size() <= kNameBytes) return text;
  std::size_t end = kNameBytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  text.resize(end);
  return text;
}

Value error_json(const Error& error) {
  return Dict{{"path", cut(error.path)}, {"code", race::name(error.code)}, {"message", cut(error.message)}};
}

std::optional<double> tool_speed_of(const Message& message) {
  if (message.value.is_null()) return std::nullopt;
  return message.value.to_double();
}

services::PacketPtr packet_of(Message message) {
  auto packet = std::make_shared<services::Packet>();
  packet->time = message.time;
  packet->header = std::move(message.value.freeze());
  packet->bytes = std::move(message.bytes);
  return packet;
}

}  // namespace race::remote
