#include "server/accounts/accounts.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <tuple>

#include "server/accounts/secret.h"
#include "services/sqlite/digest.h"
#include "services/sqlite/table_hash.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StrCaseEq;

constexpr std::int64_t kNow = 1'000'000;

Account person(const std::string& name, Role role) { return {name, role, {}, "hash of " + name, kNow}; }

std::string refusal_of(const Expected<void>& done) {
  return done ? "" : std::string(name(done.error().code)) + ' ' + done.error().path;
}

struct AccountsTest : testing::Test {
  AccountsTest() { reopen(); }
  void reopen() {
    accounts.reset();
    accounts = Accounts::open(file).value();
  }
  std::string login(const std::string& name) {
    return accounts->issue(name, std::string(Accounts::kLogin), kNow, kNow + 1000)->secret;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Account& account : accounts->list()) names.push_back(account.name);
    return names;
  }

  TemporaryFolder place;
  const std::string file = place.file("accounts.sqlite");
  std::unique_ptr<Accounts> accounts;
};

TEST_F(AccountsTest, ThereAreNoneAtFirstAndTheFirstIsAnAdminWithAPassword) {
  EXPECT_TRUE(accounts->empty());
  EXPECT_EQ(refusal_of(accounts->add(person("eve", Role::developer))), "not_accepted role");
  EXPECT_EQ(refusal_of(accounts->add({"ada", Role::admin, {}, "", kNow})), "not_accepted role");
  EXPECT_TRUE(accounts->add(person("ada", Role::admin)));
  EXPECT_TRUE(accounts->add(person("eve", Role::developer)));
  EXPECT_FALSE(accounts->empty());
}

TEST_F(AccountsTest, AreThereWhenTheFileIsOpenedAgain) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  ASSERT_TRUE(accounts->add({"robot-1", Role::process, {"cell", "audio"}, "", kNow}));
  const std::string token = accounts->issue("robot-1", "cell", kNow, 0)->secret;
  const std::vector<Account> before = accounts->list();
  reopen();
  EXPECT_EQ(accounts->list(), before);
  const auto who = accounts->identify(token, kNow + 1'000'000'000);
  ASSERT_TRUE(who) << "a token without an end";
  EXPECT_EQ(who->account, "robot-1");
  EXPECT_EQ(who->role, Role::process);
  EXPECT_THAT(who->groups, ElementsAre("cell", "audio"));
}

TEST_F(AccountsTest, HaveNamesThatAreSafeEverywhere) {
  for (const char* name : {"", "a b", "a/b", "-a", ".a", "ä", "a~b", "a:b", "../a"})
    EXPECT_EQ(refusal_of(accounts->add(person(name, Role::admin))), "name name") << name;
  EXPECT_EQ(refusal_of(accounts->add(person(std::string(41, 'a'), Role::admin))), "name name");
  EXPECT_TRUE(accounts->add(person(std::string(40, 'a'), Role::admin)));
  EXPECT_TRUE(accounts->add(person("A.b-c_9", Role::admin)));
}

TEST_F(AccountsTest, AProcessHasGroupsAndNoPasswordAndAPersonTheReverse) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  EXPECT_EQ(refusal_of(accounts->add({"p", Role::process, {}, "", kNow})), "missing groups");
  EXPECT_EQ(refusal_of(accounts->add({"p", Role::process, {"cell"}, "hash", kNow})), "not_accepted password");
  EXPECT_EQ(refusal_of(accounts->add({"p", Role::cell_operator, {"cell"}, "hash", kNow})), "not_accepted groups");
  EXPECT_EQ(refusal_of(accounts->change("ada", {.role = Role::process})), "not_accepted role");
}

TEST_F(AccountsTest, ANameIsTakenOnce) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  EXPECT_EQ(refusal_of(accounts->add(person("ada", Role::observer))), "conflict name");
  EXPECT_EQ(accounts->find("ada")->role, Role::admin);
}

TEST_F(AccountsTest, TheLastAdminStays) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  ASSERT_TRUE(accounts->add({"no-password", Role::admin, {}, "", kNow}));
  EXPECT_EQ(refusal_of(accounts->remove("ada")), "conflict ada");
  EXPECT_EQ(refusal_of(accounts->change("ada", {.role = Role::developer})), "conflict ada");
  ASSERT_TRUE(accounts->add(person("eve", Role::admin)));
  EXPECT_TRUE(accounts->remove("ada"));
  EXPECT_EQ(refusal_of(accounts->remove("ada")), "not_found ada");
  EXPECT_THAT(names(), ElementsAre("eve", "no-password"));
}

TEST_F(AccountsTest, ATokenIsOfItsAccountUntilItExpires) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  const std::string token = login("ada");
  EXPECT_EQ(accounts->identify(token, kNow + 999)->account, "ada");
  EXPECT_FALSE(accounts->identify(token, kNow + 1000));
  EXPECT_FALSE(accounts->identify(token + "x", kNow));
  EXPECT_FALSE(accounts->identify("", kNow));
  EXPECT_FALSE(accounts->is_current(*accounts->identify(token, kNow), kNow + 1000));
}

TEST_F(AccountsTest, ATokenEndsWithALogoutANewPasswordAndItsAccount) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  ASSERT_TRUE(accounts->add(person("eve", Role::cell_operator)));
  for (const std::string how : {"logout", "password", "removed"}) {
    const std::string token = login("eve");
    const auto who = accounts->identify(token, kNow);
    ASSERT_TRUE(who && accounts->is_current(*who, kNow)) << how;
    if (how == "logout") {
      EXPECT_EQ(refusal_of(accounts->revoke("ada", who->token)), "not_found " + who->token);
      ASSERT_TRUE(accounts->revoke("eve", who->token));
    }
    if (how == "password") {
      ASSERT_TRUE(accounts->change("eve", {.password_hash = "another"}));
    }
    if (how == "removed") {
      ASSERT_TRUE(accounts->remove("eve"));
    }
    EXPECT_FALSE(accounts->identify(token, kNow)) << how;
    EXPECT_FALSE(accounts->is_current(*who, kNow)) << how;
    reopen();
    EXPECT_FALSE(accounts->identify(token, kNow)) << how;
  }
}

// A password is compared long before its token is made.
TEST_F(AccountsTest, APasswordThatIsAnotherByNowBringsNothing) {
  const auto code = [](const auto& done) { return done ? "" : std::string(name(done.error().code)); };
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  ASSERT_TRUE(accounts->add(person("eve", Role::observer)));
  const std::string old = accounts->find("eve")->password_hash;
  const auto login = [&](const std::string& hash) { return accounts->issue_login("eve", hash, kNow, kNow + 1000); };
  ASSERT_EQ(code(login(old)), "");
  ASSERT_TRUE(accounts->change("eve", {.password_hash = "another", .old_password_hash = old}));
  EXPECT_EQ(code(login(old)), "conflict");
  EXPECT_EQ(refusal_of(accounts->change("eve", {.password_hash = "third", .old_password_hash = old})),
            "conflict password");
  EXPECT_EQ(accounts->find("eve")->password_hash, "another");
  ASSERT_TRUE(accounts->remove("eve"));
  EXPECT_EQ(code(login("another")), "not_found");
  ASSERT_TRUE(accounts->add({"eve", Role::observer, {}, "of a new account", kNow}));
  EXPECT_EQ(code(login("another")), "conflict");
  EXPECT_THAT(accounts->tokens("eve", kNow), SizeIs(0));
}

TEST_F(AccountsTest, AnIdentityIsNoMoreWhatItWasWhenItsRoleChanges) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  ASSERT_TRUE(accounts->add(person("eve", Role::developer)));
  const std::string token = login("eve");
  const Identity who = *accounts->identify(token, kNow);
  ASSERT_TRUE(accounts->change("eve", {.role = Role::observer}));
  EXPECT_FALSE(accounts->is_current(who, kNow));
  EXPECT_EQ(accounts->identify(token, kNow)->role, Role::observer);
}

TEST_F(AccountsTest, ATokenMayTheLowerOfItsRoleAndItsAccounts) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  ASSERT_TRUE(accounts->add(person("eve", Role::developer)));
  const std::string token = accounts->issue("eve", "phone", kNow, 0, {Role::cell_operator})->secret;
  const auto role = [&] { return accounts->identify(token, kNow)->role; };
  EXPECT_EQ(role(), Role::cell_operator);
  const std::vector<std::pair<Role, Role>> expectations = {
      {Role::observer, Role::observer}, {Role::cell_operator, Role::cell_operator}, {Role::admin, Role::cell_operator}};
  for (const auto& [of_account, expected] : expectations) {
    const Identity before = *accounts->identify(token, kNow);
    ASSERT_TRUE(accounts->change("eve", {.role = of_account}));
    EXPECT_EQ(role(), expected);
    EXPECT_EQ(accounts->is_current(before, kNow), before.role == expected);
  }
  reopen();
  EXPECT_EQ(role(), Role::cell_operator);
}

TEST_F(AccountsTest, ATokenMayBeOfADisplayAtTheCell) {
  ASSERT_TRUE(accounts->add({"ada", Role::admin, {}, "hash", kNow}));
  ASSERT_TRUE(accounts->add({"cell", Role::observer, {"local"}, "", kNow}));
  const auto who = [&](const std::string& account, const TokenScope& scope) {
    return *accounts->identify(accounts->issue(account, "phone", kNow, 0, scope)->secret, kNow);
  };
  EXPECT_THAT(who("ada", {}).groups, IsEmpty());
  EXPECT_THAT(who("ada", {{}, true}).groups, ElementsAre("local"));
  EXPECT_THAT(who("cell", {{}, true}).groups, ElementsAre("local")) << "once";
  EXPECT_TRUE(is_local(who("ada", {Role::observer, true, "phone1"})));
  const std::vector<AccountToken> before = accounts->tokens("ada", kNow);
  reopen();
  EXPECT_EQ(accounts->tokens("ada", kNow), before);
}

TEST_F(AccountsTest, ATokenIsNotMadeThatMayMoreThanItsAccountNorOneOfAProcess) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  ASSERT_TRUE(accounts->add(person("eve", Role::cell_operator)));
  ASSERT_TRUE(accounts->add({"robot-1", Role::process, {"cell"}, "", kNow}));
  const auto refusal = [&](const std::string& account, const TokenScope& scope) {
    const auto token = accounts->issue(account, "phone", kNow, 0, scope);
    return token ? "" : std::string(name(token.error().code)) + ' ' + token.error().path;
  };
  EXPECT_EQ(refusal("eve", {Role::developer}), "not_accepted role");
  EXPECT_EQ(refusal("eve", {Role::cell_operator}), "");
  EXPECT_EQ(refusal("eve", {Role::process}), "not_accepted role");
  EXPECT_EQ(refusal("robot-1", {Role::process}), "not_accepted role");
  EXPECT_EQ(refusal("robot-1", {Role::observer}), "not_accepted role");
  EXPECT_EQ(refusal("robot-1", {{}, true}), "not_accepted local");
}

TEST_F(AccountsTest, ATokenIsMadeForWhoWantedItWhileTheyAreWhoTheyWere) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  ASSERT_TRUE(accounts->add(person("eve", Role::developer)));
  const auto refusal = [&](const Identity& by) {
    const auto token = accounts->issue_for(by, "phone", kNow, 0, {Role::observer});
    return token ? "" : std::string(name(token.error().code));
  };
  Identity eve = *accounts->identify(login("eve"), kNow);
  EXPECT_EQ(refusal(eve), "");
  ASSERT_TRUE(accounts->change("eve", {.role = Role::cell_operator}));
  EXPECT_EQ(refusal(eve), "conflict") << "another role";
  eve = *accounts->identify(login("eve"), kNow);
  ASSERT_TRUE(accounts->revoke("eve", eve.token));
  EXPECT_EQ(refusal(eve), "conflict") << "logged out";
  eve = *accounts->identify(login("eve"), kNow);
  ASSERT_TRUE(accounts->remove("eve"));
  EXPECT_EQ(refusal(eve), "not_found") << "removed";
  ASSERT_TRUE(accounts->add(person("eve", Role::cell_operator)));
  EXPECT_EQ(refusal(eve), "conflict") << "another account of this name";
}

TEST_F(AccountsTest, TokensAreListedFromTheOldestOnAndOfOneMillisecondByTheirDigests) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  for (int i = 0; i < 40; ++i) ASSERT_TRUE(accounts->issue("ada", "script", kNow - i % 2, 0));
  const std::vector<AccountToken> tokens = accounts->tokens("ada", kNow);
  ASSERT_THAT(tokens, SizeIs(40));
  for (std::size_t i = 1; i < tokens.size(); ++i)
    EXPECT_LT(std::tie(tokens[i - 1].created, tokens[i - 1].digest), std::tie(tokens[i].created, tokens[i].digest));
}

// Of version 1: tokens have no scope.
TEST_F(AccountsTest, AnOlderFileKeepsItsTokensAndADamagedOneIsNotMadeWhole) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  const std::string token = login("ada");
  const auto make_older = [&](const std::string& damage) {
    accounts.reset();
    SQLite::Database old(file, SQLite::OPEN_READWRITE);
    old.exec(
        "ALTER TABLE token DROP COLUMN role; ALTER TABLE token DROP COLUMN local;"
        "ALTER TABLE token DROP COLUMN display; PRAGMA user_version = 1;" +
        damage);
    sqlite::keep_schema(old);
    return old.execAndGet("SELECT hex(digest) FROM token").getString();
  };
  // As version 1 has it.
  const sqlite::Digest digest = sqlite::sha256_of(
      {"token", digest_of_secret(token), "ada", Accounts::kLogin, std::to_string(kNow), std::to_string(kNow + 1000)});
  EXPECT_THAT(make_older(""), StrCaseEq(sqlite::hex(digest)));
  reopen();
  EXPECT_EQ(accounts->identify(token, kNow)->role, Role::admin);
  EXPECT_EQ(accounts->tokens("ada", kNow).front().scope, TokenScope());
  EXPECT_TRUE(accounts->issue("ada", "phone", kNow + 1, 0, {Role::observer, true, "phone1"}));
  ASSERT_TRUE(accounts->revoke("ada", accounts->tokens("ada", kNow).back().digest));
  make_older("UPDATE token SET expires = 0");
  EXPECT_EQ(Accounts::open(file).error().code, ErrorCode::corrupt);
}

TEST_F(AccountsTest, NobodyInParticularIsCurrentWhileThereAreNoAccounts) {
  EXPECT_TRUE(accounts->is_current(Identity(), kNow));
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  EXPECT_FALSE(accounts->is_current(Identity(), kNow));
}

TEST_F(AccountsTest, BeyondTheBoundTheOldestLoginEndsAndOtherTokensAreRefused) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  std::vector<std::string> logins;
  for (std::size_t i = 0; i <= Accounts::kMostTokens; ++i) {
    const auto now = kNow + static_cast<std::int64_t>(i);
    logins.push_back(accounts->issue("ada", "login", now, 2 * kNow)->secret);
  }
  EXPECT_FALSE(accounts->identify(logins[0], kNow + 200));
  EXPECT_TRUE(accounts->identify(logins[1], kNow + 200));
  EXPECT_TRUE(accounts->identify(logins.back(), kNow + 200));
  for (std::size_t i = 0; i < Accounts::kMostTokens; ++i) ASSERT_TRUE(accounts->issue("ada", "script", kNow, 0));
  EXPECT_EQ(accounts->issue("ada", "script", kNow, 0).error().code, ErrorCode::too_large);
  EXPECT_TRUE(accounts->issue("ada", "login", kNow + 300, 2 * kNow)) << "scripts keep nobody out";
  EXPECT_THAT(accounts->tokens("ada", kNow + 300), SizeIs(2 * Accounts::kMostTokens));
}

TEST_F(AccountsTest, ThereAreAtMostTwoHundred) {
  for (std::size_t i = 0; i < Accounts::kMost; ++i)
    ASSERT_TRUE(accounts->add(person("a" + std::to_string(i), Role::admin)));
  EXPECT_EQ(accounts->add(person("more", Role::admin)).error().code, ErrorCode::too_large);
  EXPECT_THAT(accounts->list(), SizeIs(Accounts::kMost));
}

TEST_F(AccountsTest, TheFileIsForItsOwnerAloneAndHoldsNoToken) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  const std::string token = login("ada");
  struct stat known {};
  ASSERT_EQ(::stat(file.c_str(), &known), 0);
  EXPECT_EQ(known.st_mode & 0777U, 0600U);
  accounts.reset();
  SQLite::Database database(file);
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM token WHERE secret LIKE '%race_%'").getInt(), 0);
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM token").getInt(), 1);
}

// Otherwise a damaged file would be a server that lets everybody in.
TEST_F(AccountsTest, AFileThatLostOrChangedARowIsDamagedNotEmpty) {
  ASSERT_TRUE(accounts->add(person("ada", Role::admin)));
  login("ada");
  accounts.reset();
  const TemporaryFolder saved;
  std::filesystem::copy_file(file, saved.file("accounts"));
  for (const char* damage :
       {"DELETE FROM account", "UPDATE account SET role = 'observer'", "UPDATE account SET hash = ''",
        "DELETE FROM token", "UPDATE token SET expires = 0", "UPDATE account SET role = 'king'",
        "UPDATE token SET role = 'observer'", "UPDATE token SET role = 'king'", "UPDATE token SET local = 1",
        "UPDATE token SET display = 'phone1'", "DROP TABLE account", "DELETE FROM table_hash"}) {
    std::filesystem::copy_file(saved.file("accounts"), file, std::filesystem::copy_options::overwrite_existing);
    SQLite::Database(file, SQLite::OPEN_READWRITE).exec(damage);
    const auto opened = Accounts::open(file);
    ASSERT_FALSE(opened) << damage;
    EXPECT_EQ(opened.error().code, ErrorCode::corrupt) << damage;
  }
}

}  // namespace
}  // namespace race::server
