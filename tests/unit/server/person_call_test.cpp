#include "server/control/person_call.h"

#include <gtest/gtest.h>

#include "core/value/json.h"

namespace race::server {
namespace {

std::string response(const Value& data, bool is_error = false) {
  services::Delivery delivery;
  delivery.data = data;
  delivery.is_error = is_error;
  delivery.units = data.size_units();
  return to_json(response_json(delivery));
}

TEST(PersonCall, IsAnsweredWithAResultOrAnError) {
  EXPECT_EQ(response(3), R"({"result":3})");
  EXPECT_EQ(response(Dict{{"code", "busy"}}, true), R"({"error":{"code":"busy"}})");
}

TEST(PersonCall, AResponseHas16KiUnitsAtMost) {
  Value data;
  for (std::size_t length = PersonCall::kMostUnits; data.size_units() != PersonCall::kMostUnits; --length)
    data = std::string(length, 'x');
  EXPECT_TRUE(response(data).starts_with(R"({"result":)"));
  EXPECT_TRUE(response(data.as_string() + "x").starts_with(R"({"error":{"code":"too_large")"));
}

TEST(PersonCalls, SixteenWaitAndEachIsAnsweredOnce) {
  PersonCalls calls;
  int answered = 0;
  const auto respond = [&](const Expected<Dict>&) { ++answered; };
  for (std::uint64_t number = 1; number <= 16; ++number) {
    ASSERT_TRUE(calls.may_wait(""));
    calls.add(number, {respond});
  }
  EXPECT_EQ(calls.may_wait("").error().code, ErrorCode::unavailable);
  EXPECT_EQ(calls.may_wait("ada").error().code, ErrorCode::unavailable);
  const auto seventh = calls.take(7);
  ASSERT_TRUE(seventh);
  seventh->respond({});
  EXPECT_EQ(answered, 1);
  EXPECT_FALSE(calls.take(7));
  EXPECT_TRUE(calls.may_wait(""));
}

TEST(PersonCalls, FourOfAnAccountWaitAndKeepOutNoOther) {
  PersonCalls calls;
  const auto respond = [](const Expected<Dict>&) {};
  std::uint64_t number = 0;
  for (const char* account : {"ada", "bob", "carol", "dave"}) {
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(calls.may_wait(account)) << account;
      calls.add(++number, {respond, account});
    }
    EXPECT_EQ(calls.may_wait(account).error().code, ErrorCode::too_large);
  }
  EXPECT_EQ(calls.may_wait("eve").error().code, ErrorCode::unavailable) << "all have their share";
  EXPECT_TRUE(calls.take(3));
  EXPECT_EQ(calls.may_wait("bob").error().code, ErrorCode::too_large);
  EXPECT_TRUE(calls.may_wait("ada"));
  EXPECT_TRUE(calls.may_wait("eve"));
}

}  // namespace
}  // namespace race::server
