#include "server/accounts/pairings.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace race::server {
namespace {

using namespace std::chrono_literals;
using Time = Pairings::Time;

const Identity kAda{"ada", Role::developer, {}, "digest", "10.0.0.7"};

// Ada at another page, where she has logged in, too.
Identity ada(int login) {
  Identity ada = kAda;
  ada.token += std::to_string(login);
  return ada;
}

// Of phone1, phone2, ...
Pairing phone(int number, const Identity& by = kAda) {
  return {by, {Role::cell_operator, true, "phone" + std::to_string(number)}, "table", 30};
}

// Of a login of its own, and of an account for each eight.
Pairing phone_of_many(int number) {
  return phone(number, {"guest" + std::to_string(number / 8), Role::developer, {}, "login" + std::to_string(number)});
}

TEST(Pairings, ACodeLetsOnePhoneIn) {
  Pairings pairings;
  const std::string one = *pairings.issue(phone(1), {}), other = *pairings.issue(phone(2, ada(2)), {});
  const auto pairing = pairings.take(one, {});
  ASSERT_TRUE(pairing);
  EXPECT_EQ(pairing->by, kAda);
  EXPECT_EQ(pairing->scope, (TokenScope{Role::cell_operator, true, "phone1"}));
  EXPECT_EQ(pairing->place, "table");
  EXPECT_EQ(pairing->days, 30);
  EXPECT_FALSE(pairings.take(one, {})) << "once";
  EXPECT_EQ(pairings.take(other, {})->scope.display, "phone2");
}

TEST(Pairings, ACodeIsGoodForAMinute) {
  Pairings pairings;
  const std::string early = *pairings.issue(phone(1), {}), late = *pairings.issue(phone(2, ada(2)), {});
  EXPECT_TRUE(pairings.take(early, Time{} + 60s - 1ns));
  EXPECT_FALSE(pairings.take(late, Time{} + 60s));
  EXPECT_FALSE(pairings.take(late, Time{})) << "who came too late has used it up";
}

TEST(Pairings, ACodeHas128RandomBits) {
  Pairings pairings;
  const std::string one = *pairings.issue(phone(1), {}), other = *pairings.issue(phone(1, ada(2)), {});
  EXPECT_NE(one, other);
  EXPECT_EQ(one.size(), 22U);
  EXPECT_EQ(one.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_"),
            std::string::npos);
  for (const std::string& wrong : {std::string(), one.substr(1), one + "A", one + one, std::string(22, 'A')})
    EXPECT_FALSE(pairings.take(wrong, {})) << wrong;
  EXPECT_TRUE(pairings.take(one, {}));
}

TEST(Pairings, ANewCodeOfALoginReplacesItsOlderOneAndNoOther) {
  Pairings pairings;
  const Identity bob{"bob", Role::developer, {}, kAda.token};
  const std::string elsewhere = *pairings.issue(phone(1, ada(2)), {}), of_bob = *pairings.issue(phone(1, bob), {});
  std::string last = *pairings.issue(phone(1), {});
  for (int i = 0; i < 100; ++i) {
    const auto next = pairings.issue(phone(1), {});
    ASSERT_TRUE(next) << "a page that is loaded again";
    EXPECT_FALSE(pairings.take(std::exchange(last, *next), {}));
  }
  for (const std::string& code : {last, elsewhere, of_bob}) EXPECT_TRUE(pairings.take(code, {}));
}

TEST(Pairings, EightOfAnAccountWaitAndKeepOutNoOther) {
  Pairings pairings;
  const Identity bob{"bob", Role::developer};
  EXPECT_TRUE(pairings.issue(phone(0, bob), {}));
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(pairings.issue(phone(i, ada(i)), Time{} + 1s));
  const Time later = Time{} + 10s;
  const auto refused = pairings.issue(phone(8, ada(8)), later);
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().of_account);
  EXPECT_EQ(refused.error().most, 8U);
  EXPECT_EQ(refused.error().wait, 51s) << "until the first of theirs is too old";
  EXPECT_TRUE(pairings.issue(phone(1, bob), later));
  EXPECT_TRUE(pairings.issue(phone(8, ada(8)), Time{} + 61s));
}

TEST(Pairings, AtMost64Wait) {
  Pairings pairings;
  std::vector<std::string> codes;
  for (int i = 0; i < 64; ++i) codes.push_back(*pairings.issue(phone_of_many(i), Time{} + i * 1ms));
  const Time later = Time{} + 10s;
  const auto refused = pairings.issue(phone(65), later);
  ASSERT_FALSE(refused);
  EXPECT_FALSE(refused.error().of_account);
  EXPECT_EQ(refused.error().wait, 50s) << "until the first is too old";
  EXPECT_TRUE(pairings.take(codes[7], later)) << "none has made way";
  EXPECT_TRUE(pairings.issue(phone(65), later));
  EXPECT_FALSE(pairings.issue(phone_of_many(66), later));
  EXPECT_TRUE(pairings.issue(phone_of_many(66), Time{} + 60s)) << "the first is too old";
  EXPECT_FALSE(pairings.issue(phone_of_many(67), Time{} + 60s)) << "and only that";
}

}  // namespace
}  // namespace race::server
