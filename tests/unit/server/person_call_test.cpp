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

using enum PersonCalls::Place;

TEST(PersonCalls, SixteenWaitAndEachIsAnsweredOnce) {
  PersonCalls calls;
  int answered = 0;
  const auto respond = [&](const Expected<Dict>&) { ++answered; };
  for (std::uint64_t number = 1; number <= 16; ++number) {
    ASSERT_TRUE(calls.may_wait(others, ""));
    calls.add(number, {respond});
  }
  EXPECT_EQ(calls.may_wait(others, "").error().code, ErrorCode::unavailable);
  EXPECT_EQ(calls.may_wait(others, "ada").error().code, ErrorCode::unavailable);
  const auto seventh = calls.take(7);
  ASSERT_TRUE(seventh);
  seventh->respond({});
  EXPECT_EQ(answered, 1);
  EXPECT_FALSE(calls.take(7));
  EXPECT_TRUE(calls.may_wait(others, ""));
}

TEST(PersonCalls, FourOfAnAccountWaitAndKeepOutNoOther) {
  PersonCalls calls;
  const auto respond = [](const Expected<Dict>&) {};
  std::uint64_t number = 0;
  for (const char* account : {"ada", "bob", "carol", "dave"}) {
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(calls.may_wait(others, account)) << account;
      calls.add(++number, {respond, others, account});
    }
    EXPECT_EQ(calls.may_wait(others, account).error().code, ErrorCode::too_large);
  }
  EXPECT_EQ(calls.may_wait(others, "eve").error().code, ErrorCode::unavailable) << "all have their share";
  EXPECT_TRUE(calls.take(3));
  EXPECT_EQ(calls.may_wait(others, "bob").error().code, ErrorCode::too_large);
  EXPECT_TRUE(calls.may_wait(others, "ada"));
  EXPECT_TRUE(calls.may_wait(others, "eve"));
}

TEST(PersonCalls, WhatReadsWhatStopsAndAllElseHavePlacesOfTheirOwn) {
  using rsm::CallEffect;
  EXPECT_EQ(PersonCalls::place_of(CallEffect::none), reads);
  EXPECT_EQ(PersonCalls::place_of(CallEffect::stop), stops);
  for (const auto effect : {CallEffect::change, CallEffect::pace, CallEffect::motion})
    EXPECT_EQ(PersonCalls::place_of(effect), others);
  PersonCalls calls;
  std::uint64_t number = 0;
  const auto fill = [&](PersonCalls::Place place, std::size_t many, const char* account) {
    for (std::size_t i = 0; i < many; ++i) {
      ASSERT_TRUE(calls.may_wait(place, account));
      calls.add(++number, {[](const Expected<Dict>&) {}, place, account});
    }
  };
  for (const auto place : {reads, others, stops}) {
    fill(place, PersonCalls::kMostOfAccount, "ada");
    EXPECT_EQ(calls.may_wait(place, "ada").error().code, ErrorCode::too_large);
    fill(place, PersonCalls::kMost - PersonCalls::kMostOfAccount, "");
    EXPECT_EQ(calls.may_wait(place, "").error().code, ErrorCode::unavailable);
  }
}

}  // namespace
}  // namespace race::server
