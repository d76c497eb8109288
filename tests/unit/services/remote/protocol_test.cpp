#include "services/remote/protocol.h"

#include <gmock/gmock.h>

#include <random>

#include "core/value/json.h"

namespace race::remote {
namespace {

using testing::HasSubstr;

constexpr int kKinds = static_cast<int>(Kind::violation) + 1;

// Each field has a value of its own; a kind keeps those it has.
Message full(Kind kind) {
  Message message;
  message.kind = kind;
  message.key = "db";
  message.name = "get";
  message.service = "camera";
  message.call = 7;
  message.number = 3;
  message.on = true;
  message.time = 1.25;
  message.value = Dict{{"code", "not_found"}, {"n", 1}, {"x", 1.0}};
  if (kind == Kind::hello || kind == Kind::refused) message.value = List{Dict{{"key", "db"}}};
  if (kind == Kind::limit_speed) message.value = 0.25;
  if (kind == Kind::violation) message.value = "the state is `Dark`";
  message.world = Dict{{"scene", 5}};
  message.args = {1, 2.0, "three"};
  message.kwargs = {{"four", nullptr}};
  for (int i = 0; i < 300; ++i) message.bytes.push_back(static_cast<std::byte>(i));
  return message;
}

std::string text_error(std::string text, Reader reader = Reader::server, bool binary = false) {
  const auto message = decode({std::move(text), binary}, reader);
  return message ? "none" : to_string(message.error());
}

TEST(Protocol, EveryMessageComesAsItWent) {
  for (int i = 0; i < kKinds; ++i) {
    const Message sent = full(static_cast<Kind>(i));
    SCOPED_TRACE(name(sent.kind));
    const auto encoded = encode(sent);
    ASSERT_TRUE(encoded);
    const auto got = decode(*encoded, reader_of(sent.kind));
    ASSERT_TRUE(got) << to_string(got.error());
    EXPECT_EQ(got->kind, sent.kind);
    const auto again = encode(*got);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->bytes, encoded->bytes);
    EXPECT_EQ(again->binary, encoded->binary);
  }
}

TEST(Protocol, ACallKeepsItsArguments) {
  const auto got = decode(encode(full(Kind::call)).value(), Reader::process);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->key, "db");
  EXPECT_EQ(got->name, "get");
  EXPECT_EQ(got->call, 7U);
  EXPECT_EQ(Value(got->args), Value(List{1, 2.0, "three"}));
  EXPECT_EQ(Value(got->kwargs), Value(Dict{{"four", nullptr}}));
  EXPECT_EQ(got->time, 1.25);
}

TEST(Protocol, APacketKeepsItsBytesAndIsFrozen) {
  const Message sent = full(Kind::packet);
  auto got = decode(encode(sent).value(), Reader::process);
  ASSERT_TRUE(got);
  const auto packet = packet_of(std::move(*got));
  EXPECT_EQ(packet->bytes, sent.bytes);
  EXPECT_EQ(packet->time, 1.25);
  EXPECT_EQ(packet->header, sent.value);
}

TEST(Protocol, AMessageOfTheOtherDirectionIsRefused) {
  for (int i = 0; i < kKinds; ++i) {
    const Kind kind = static_cast<Kind>(i);
    const Reader wrong = reader_of(kind) == Reader::server ? Reader::process : Reader::server;
    const auto got = decode(encode(full(kind)).value(), wrong);
    ASSERT_FALSE(got) << name(kind);
    EXPECT_EQ(got.error().code, ErrorCode::type);
  }
}

TEST(Protocol, WhatDoesNotFitIsRefusedWithItsField) {
  EXPECT_THAT(text_error("{"), HasSubstr("json"));
  EXPECT_THAT(text_error("[]"), HasSubstr("type: type"));
  EXPECT_THAT(text_error(R"({"type": "sing"})"), HasSubstr("type: type: there is no such text message"));
  EXPECT_THAT(text_error(R"({"type": "pong"})"), HasSubstr("number: missing"));
  EXPECT_THAT(text_error(R"({"type": "pong", "number": "1"})"), HasSubstr("number: type"));
  EXPECT_THAT(text_error(R"({"type": "pong", "number": -1})"), HasSubstr("number: out_of_range"));
  EXPECT_THAT(text_error(R"({"type": "pong", "number": 1, "extra": 1})"), HasSubstr("unknown_field"));
  EXPECT_THAT(text_error(R"({"type": "error", "key": "db", "call": 1, "error": {}})"), HasSubstr("error: type"));
  EXPECT_THAT(text_error(R"({"type": "hello", "protocol": 1, "components": {}})"), HasSubstr("components: type"));
  EXPECT_THAT(
      text_error(R"({"type": "event", "key": "db", "name": ")" + std::string(kNameBytes + 1, 'x') + R"(", "data": 1})"),
      HasSubstr("name: out_of_range"));
}

TEST(Protocol, ALimitOfTheSpeedIsANumberOrNone) {
  const auto limit = [](const std::string& speed) {
    return R"({"type": "limit_speed", "key": "robot", "tool_speed": )" + speed + R"(, "time": 1})";
  };
  const auto read = [&](const std::string& speed) { return decode({limit(speed), false}, Reader::process).value(); };
  EXPECT_EQ(tool_speed_of(read("0.25")), 0.25);
  EXPECT_EQ(tool_speed_of(read("0")), 0);
  EXPECT_EQ(tool_speed_of(read("null")), std::nullopt);
  EXPECT_THAT(text_error(limit("-0.1"), Reader::process), HasSubstr("tool_speed: out_of_range"));
  EXPECT_THAT(text_error(limit(R"("slow")"), Reader::process), HasSubstr("tool_speed: type"));
  EXPECT_THAT(text_error(limit("true"), Reader::process), HasSubstr("tool_speed: type"));
  EXPECT_THAT(text_error(R"({"type": "limit_speed", "key": "robot", "time": 1})", Reader::process),
              HasSubstr("tool_speed: missing"));
}

TEST(Protocol, AHelloMayAskForViolations) {
  const std::string hello = R"({"type": "hello", "protocol": 1, "components": [])";
  EXPECT_FALSE(decode({hello + "}", false}, Reader::server).value().on);
  EXPECT_TRUE(decode({hello + R"(, "violations": true})", false}, Reader::server).value().on);
  EXPECT_THAT(text_error(hello + R"(, "violations": 1})"), HasSubstr("violations: type"));
}

TEST(Protocol, AViolationIsAText) {
  EXPECT_THAT(text_error(R"({"type": "violation", "key": "a", "rule": "put", "message": 5, "call": 0, "operation": "",
                             "time": 1})",
                         Reader::process),
              HasSubstr("message: type"));
}

TEST(Protocol, BytesThatAreShorterThanTheySayAreRefused) {
  EXPECT_THAT(text_error("", Reader::server, true), HasSubstr("out_of_range"));
  EXPECT_THAT(text_error(std::string("\x00\x00\x00", 3), Reader::server, true), HasSubstr("out_of_range"));
  EXPECT_THAT(text_error("\xff\xff\xff\xff{}", Reader::server, true), HasSubstr("out_of_range"));
  EXPECT_THAT(text_error(std::string("\x00\x00\x00\x02{}", 6), Reader::server, true), HasSubstr("type"));
  // A text message as bytes.
  EXPECT_THAT(text_error(std::string("\x00\x00\x00\x1d", 4) + R"({"type": "pong", "number": 1})", Reader::server, true),
              HasSubstr("there is no such binary message"));
}

TEST(Protocol, WhatIsTooLargeIsNotSent) {
  Message message = full(Kind::result);
  message.value = std::string(kMessageBytes, 'x');
  const auto encoded = encode(message);
  ASSERT_FALSE(encoded);
  EXPECT_EQ(encoded.error().code, ErrorCode::too_large);
}

TEST(Protocol, TheHeaderOfAPacketIsShort) {
  Message message = full(Kind::publish);
  message.value = Dict{{"x", std::string(kHeaderBytes, 'x')}};
  EXPECT_EQ(encode(message).error().code, ErrorCode::too_large);
  const std::string length{0, 1, 0, 1};  // one byte more
  EXPECT_THAT(text_error(length + std::string(kHeaderBytes + 1, ' '), Reader::server, true), HasSubstr("too_large"));
}

TEST(Protocol, WhatIsNotFiniteIsNotSent) {
  Message message = full(Kind::result);
  message.value = List{std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(encode(message).error().code, ErrorCode::constant);
}

// Messages with bytes changed, cut and put in: each is read or refused, and what is read can be sent again.
TEST(Protocol, DamagedMessagesAreReadOrRefused) {
  std::mt19937 random(20);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    const Kind kind = static_cast<Kind>(below(kKinds));
    EncodedMessage encoded = encode(full(kind)).value();
    for (std::size_t damage = 0; damage <= below(3); ++damage) {
      const std::size_t at = below(encoded.bytes.size());
      switch (below(4)) {
        case 0:
          encoded.bytes[at] = static_cast<char>(below(256));
          break;
        case 1:
          encoded.bytes.erase(at, 1 + below(8));
          break;
        case 2:
          encoded.bytes.insert(at, 1, "{}[]\":,0e-"[below(10)]);
          break;
        default:
          encoded.bytes.insert(at, encoded.bytes.substr(below(encoded.bytes.size()), below(20)));
      }
      if (encoded.bytes.empty()) encoded.bytes = "x";
    }
    const auto message = decode(encoded, reader_of(kind));
    if (!message) {
      ++refused;
      continue;
    }
    EXPECT_TRUE(encode(*message));
  }
  EXPECT_GT(refused, 10000);
}

}  // namespace
}  // namespace race::remote
