#include "server/accounts/gate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <fstream>

#include "server/wire/calendar.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

using testing::ElementsAre;

TEST(Rights, EachRoleMayWhatThoseBeforeItMayAndAProcessOnlyConnect) {
  constexpr std::array kRoles = {Role::process, Role::observer, Role::cell_operator, Role::developer, Role::admin};
  const auto may = [&](Right right) {
    std::string roles;
    for (const Role role : kRoles) roles += has_right(role, right) ? '1' : '0';
    return roles;
  };
  EXPECT_EQ(may(Right::anyone), "11111");
  EXPECT_EQ(may(Right::process), "10000");
  EXPECT_EQ(may(Right::observer), "01111");
  EXPECT_EQ(may(Right::cell_operator), "00111");
  EXPECT_EQ(may(Right::developer), "00011");
  EXPECT_EQ(may(Right::admin), "00001");
}

TEST(Rights, HaveTheNamesOfTheTable) {
  for (const char* text : {"process", "observer", "operator", "developer", "admin"}) {
    EXPECT_EQ(name(*role_of(text)), text);
    EXPECT_EQ(name(*right_of(text)), text);
  }
  EXPECT_EQ(name(*right_of("anyone")), "anyone");
  EXPECT_FALSE(role_of("anyone"));
  EXPECT_FALSE(role_of("root"));
  EXPECT_FALSE(right_of(""));
}

TEST(Rights, WhatHasNoRowHasNoRight) {
  const Rights& table = Rights::table();
  EXPECT_EQ(table.of_route("GET", "/api/v1/health"), Right::anyone);
  EXPECT_EQ(table.of_route("POST", "/api/v1/health"), std::nullopt);
  EXPECT_EQ(table.of_channel("core/7/state"), Right::observer);
  EXPECT_EQ(table.of_channel("core/7/secrets"), std::nullopt);
  EXPECT_EQ(table.of_message("edit"), Right::developer);
  EXPECT_EQ(table.of_message("reboot"), std::nullopt);
}

struct GateTest : testing::Test {
  std::string token_of(const std::string& account, Role role) {
    std::vector<std::string> groups;
    if (role == Role::process) groups = {"audio"};
    EXPECT_TRUE(accounts->add({account, role, groups, role == Role::process ? "" : "hash", 1}));
    return accounts->issue(account, "login", now_ms(), now_ms() + 60'000)->secret;
  }
  // "ada" who is admitted, or 401, 403.
  std::string ask(const std::string& method, const std::string& pattern, const std::string& authorization,
                  const std::string& ticket = "") {
    const auto identity = gate.admit(method, pattern, {authorization, ticket});
    if (!identity) return identity.error().is_unknown ? "401" : "403";
    return identity->account.empty() ? std::string(name(identity->role)) : identity->account;
  }

  TemporaryFolder place;
  std::unique_ptr<Accounts> accounts = Accounts::open(place.file("accounts")).value();
  LocalKey key = LocalKey::open(place.file("key"), {"cell", "audio"}).value();
  Tickets tickets;
  Gate gate{*accounts, key, tickets};
};

TEST_F(GateTest, WithoutAccountsAnybodyIsAnAdminButNoProcess) {
  EXPECT_EQ(ask("DELETE", "/api/v1/documents/{name}", ""), "admin");
  EXPECT_EQ(ask("GET", "/api/v1/stream", ""), "admin");
  EXPECT_EQ(ask("GET", "/api/v1/components", ""), "403");
  EXPECT_EQ(ask("GET", "/api/v1/health", "Bearer race_of_a_server_that_was"), "admin");
}

TEST_F(GateTest, WithAccountsWhoIsNotKnownMayOnlyWhatAnyoneMay) {
  token_of("ada", Role::admin);
  for (const char* authorization : {"", "Bearer ", "Bearer race_x", "Basic YWRhOmFkYQ==", "Bearer"}) {
    EXPECT_EQ(ask("GET", "/api/v1/documents", authorization), "401") << authorization;
    EXPECT_EQ(ask("GET", "/api/v1/components", authorization), "401") << authorization;
    EXPECT_EQ(ask("GET", "", authorization), "401") << "nor learn which routes there are";
    EXPECT_EQ(ask("GET", "/api/v1/health", authorization), "observer") << authorization;
    EXPECT_EQ(ask("POST", "/api/v1/login", authorization), "observer") << authorization;
  }
}

TEST_F(GateTest, ATokenHasTheRightsOfItsRole) {
  const std::string admin = "Bearer " + token_of("ada", Role::admin);
  const std::string developer = "bearer " + token_of("dev", Role::developer);
  const std::string process = "Bearer " + token_of("speaker", Role::process);
  EXPECT_EQ(ask("GET", "/api/v1/accounts", admin), "ada");
  EXPECT_EQ(ask("GET", "/api/v1/accounts", developer), "403");
  EXPECT_EQ(ask("PUT", "/api/v1/documents/{name}", developer), "dev");
  EXPECT_EQ(ask("GET", "/api/v1/components", process), "speaker");
  EXPECT_EQ(ask("GET", "/api/v1/components", admin), "403") << "a person is no process";
  EXPECT_EQ(ask("GET", "/api/v1/documents", process), "403");
  EXPECT_EQ(ask("BREW", "/api/v1/coffee", admin), "403") << "a route without a row";
  EXPECT_EQ(ask("GET", "", admin), "ada") << "is told that there is no such route";
}

TEST_F(GateTest, ATicketStandsForItsTokenOnce) {
  const std::string token = token_of("ada", Role::admin);
  const Identity ada = *accounts->identify(token, now_ms());
  const std::string ticket = tickets.issue(ada, std::chrono::steady_clock::now());
  EXPECT_EQ(ask("GET", "/api/v1/stream", "", ticket), "ada");
  EXPECT_EQ(ask("GET", "/api/v1/stream", "", ticket), "401");
  const std::string late = tickets.issue(ada, std::chrono::steady_clock::now());
  ASSERT_TRUE(accounts->revoke("ada", ada.token));
  EXPECT_EQ(ask("GET", "/api/v1/stream", "", late), "401") << "of a token that is no more";
}

TEST_F(GateTest, TheKeyOfTheDataFolderIsOfProcessesWithAndWithoutAccounts) {
  const std::string secret = "Bearer " + read_token_file(place.file("key")).value();
  for (const bool with_accounts : {false, true}) {
    if (with_accounts) token_of("ada", Role::admin);
    const auto identity = gate.admit("GET", "/api/v1/components", {secret, ""});
    ASSERT_TRUE(identity);
    EXPECT_THAT(identity->groups, ElementsAre("cell", "audio"));
    EXPECT_TRUE(gate.is_current(*identity));
    EXPECT_EQ(ask("GET", "/api/v1/documents", secret), "403");
  }
}

TEST_F(GateTest, AnAuthorIsTheAccountOrOneOfItsPages) {
  const Identity ada{"ada", Role::developer};
  EXPECT_EQ(author_for(ada, ""), "ada");
  EXPECT_EQ(author_for(ada, "ada"), "ada");
  EXPECT_EQ(author_for(ada, "ada~x7"), "ada~x7");
  for (const char* other : {"eve", "adam", "ada ", "~ada", "eve~ada"}) {
    const auto author = author_for(ada, other);
    ASSERT_FALSE(author) << other;
    EXPECT_EQ(author.error().code, ErrorCode::rights);
    EXPECT_EQ(author.error().path, "author");
  }
  EXPECT_EQ(author_for(Identity(), "Guest 7~x"), "Guest 7~x") << "without accounts";
}

TEST(LocalKey, IsMadeOnceAndForItsOwnerAlone) {
  const TemporaryFolder place;
  const std::string path = place.file("processes.token");
  ASSERT_TRUE(LocalKey::open(path, {}));
  const std::string secret = read_token_file(path).value();
  EXPECT_TRUE(LocalKey::open(path, {})->is(secret));
  EXPECT_FALSE(LocalKey::open(path, {})->is(secret + "x"));
  EXPECT_FALSE(LocalKey::open(path, {})->is(""));
  struct stat known {};
  ASSERT_EQ(::stat(path.c_str(), &known), 0);
  EXPECT_EQ(known.st_mode & 0777U, 0600U);
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  EXPECT_EQ(LocalKey::open(path, {}).error().code, ErrorCode::not_accepted);
  ASSERT_EQ(::chmod(path.c_str(), 0600), 0);
  std::ofstream(path) << "something else\n";
  EXPECT_EQ(LocalKey::open(path, {}).error().code, ErrorCode::not_accepted);
}

}  // namespace
}  // namespace race::server
