// Codes that bring nothing, all answered alike, and what they cost who tries them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/value/json.h"
#include "server/accounts/accounts.h"
#include "server/accounts/attempts.h"
#include "server/accounts/pairings.h"
#include "server/handlers/handlers.h"
#include "server/handlers/network_addresses.h"
#include "server/wire/calendar.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::Field;

struct PairingTest : testing::Test {
  PairingTest() {
    EXPECT_TRUE(accounts->add({"ada", Role::admin, {}, "hash", 1}));
    EXPECT_TRUE(accounts->add({"eve", Role::cell_operator, {}, "hash", 1}));
  }
  Identity log_in(const std::string& account) {
    return *accounts->identify(accounts->issue(account, "login", now_ms(), now_ms() + 60'000)->secret, now_ms());
  }
  // A code that eve has made so long ago.
  std::string code_of(const Identity& by, std::chrono::seconds age = 0s) {
    return *pairings.issue({by, {Role::cell_operator, true, "phone1"}, "", 30}, std::chrono::steady_clock::now() - age);
  }
  Reply pair(const std::string& code, const std::string& address = "10.0.0.7") {
    Request request;
    request.body = to_json(Dict{{"code", code}});
    request.identity.address = address;
    return pair_display(request, *accounts, pairings, attempts).value();
  }
  Reply wrong() { return pair("AAAAAAAAAAAAAAAAAAAAAA", "elsewhere"); }

  const TemporaryFolder place;
  const std::unique_ptr<Accounts> accounts = Accounts::open(place.file("accounts.sqlite")).value();
  Pairings pairings;
  Attempts attempts;
};

TEST_F(PairingTest, ACodeThatIsUsedOrTooOldIsAsOneThatIsNone) {
  const Reply none = wrong();
  EXPECT_EQ(none.status, 401);
  const std::string code = code_of(log_in("eve"));
  EXPECT_EQ(pair(code).status, 200);
  EXPECT_THAT(accounts->tokens("eve", now_ms()),
              Contains(Field(&AccountToken::scope, TokenScope{Role::cell_operator, true, "phone1"})).Times(1));
  for (const Reply& reply :
       {pair(code), pair(code_of(log_in("eve"), 60s)), pair(""), pair(std::string(100'000, 'A'))}) {
    EXPECT_EQ(reply.status, none.status);
    EXPECT_EQ(to_json(reply.body), to_json(none.body));
    EXPECT_EQ(reply.headers, none.headers);
  }
}

TEST_F(PairingTest, ACodeOfSomebodyWhoMayNoMoreIsAsOneThatIsNone) {
  const std::vector<std::function<void(const Identity&)>> changes = {
      [&](const Identity&) { ASSERT_TRUE(accounts->change("eve", {.role = Role::observer})); },
      [&](const Identity& eve) { ASSERT_TRUE(accounts->revoke("eve", eve.token)); },
      [&](const Identity&) { ASSERT_TRUE(accounts->change("eve", {.password_hash = "another"})); },
      [&](const Identity&) { ASSERT_TRUE(accounts->remove("eve")); },
      [&](const Identity&) {
        ASSERT_TRUE(accounts->remove("eve"));
        ASSERT_TRUE(accounts->add({"eve", Role::admin, {}, "hash", 2}));
      }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Identity eve = log_in("eve");
    const std::string code = code_of(eve);
    changes[i](eve);
    EXPECT_EQ(to_json(pair(code).body), to_json(wrong().body)) << i;
    if (!accounts->find("eve")) {
      ASSERT_TRUE(accounts->add({"eve", Role::cell_operator, {}, "hash", 1}));
    }
    ASSERT_TRUE(accounts->change("eve", {.role = Role::cell_operator}));
  }
  EXPECT_EQ(pair(code_of(log_in("eve"))).status, 200);
}

// As passwords: ten at once of an address, whatever it tries; one that is right costs nothing.
TEST_F(PairingTest, CodesCannotBeGuessedFast) {
  for (int i = 0; i < 9; ++i) EXPECT_EQ(pair("guess").status, 401);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(pair(code_of(log_in("eve"))).status, 200);
  EXPECT_EQ(pair("guess").status, 401);
  EXPECT_EQ(pair(code_of(log_in("eve"))).status, 429) << "no code is looked at";
  EXPECT_FALSE(attempts.begin("10.0.0.7", "ada", std::chrono::steady_clock::now())) << "nor a password";
  EXPECT_EQ(pair(code_of(log_in("eve")), "10.0.0.8").status, 200) << "others are not kept out";
}

TEST_F(PairingTest, ACodeIsRefusedWhereNobodyHasAnAccount) {
  const auto none = Accounts::open(place.file("none.sqlite")).value();
  NetworkAddresses addresses;
  Request request;
  request.body = R"({"role": "observer", "name": "phone1"})";
  EXPECT_EQ(create_pairing(request, *none, pairings, addresses)->status, 409);
  request.body = R"({"code": "AAAAAAAAAAAAAAAAAAAAAA"})";
  EXPECT_EQ(pair_display(request, *none, pairings, attempts)->status, 409);
}

}  // namespace
}  // namespace race::server
