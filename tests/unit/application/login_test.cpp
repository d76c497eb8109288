// Logins and changes of a password whose account changes while their password waits to be compared.
#include <gtest/gtest.h>

#include <functional>
#include <future>

#include "core/value/json.h"
#include "server/accounts/accounts.h"
#include "server/accounts/attempts.h"
#include "server/accounts/passwords.h"
#include "server/handlers/handlers.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

constexpr const char* kOld = "correct horse battery";
constexpr const char* kNew = "another long password";

struct LoginTest : testing::Test {
  LoginTest() {
    EXPECT_TRUE(accounts->add({"ada", Role::admin, {}, hash_of(kOld), 1}));
    EXPECT_TRUE(accounts->add({"eve", Role::observer, {}, hash_of(kOld), 1}));
  }
  std::string hash_of(const char* password) const { return passwords.hash_here(password).value(); }
  static Request request(const Dict& body) {
    Request request;
    request.body = to_json(body);
    request.identity.address = "10.0.0.7";
    return request;
  }
  using Handle = std::function<void(Respond)>;
  // The status that `handle` answers when `change` happens while its password waits behind another one.
  int status(const Handle& handle, const std::function<void()>& change) {
    std::promise<void> changed;
    std::promise<int> answered;
    passwords.hash(kOld, [&](const Expected<std::string>&) { changed.get_future().wait(); });
    handle([&](const Handled& handled) { answered.set_value(handled ? handled->status : 0); });
    change();
    changed.set_value();
    return answered.get_future().get();
  }
  int login_status(const std::function<void()>& change) {
    const Request login = request({{"name", "eve"}, {"password", kOld}});
    return status([&](Respond respond) { log_in(login, std::move(respond), *accounts, passwords, attempts); }, change);
  }
  void set_password(const char* password) {
    ASSERT_TRUE(accounts->change("eve", {.password_hash = hash_of(password)}));
  }

  const TemporaryFolder place;
  const std::unique_ptr<Accounts> accounts = Accounts::open(place.file("accounts.sqlite")).value();
  Passwords passwords{PasswordCost{1, 8192}};
  Attempts attempts;
};

TEST_F(LoginTest, AnOldPasswordBringsNoTokenAfterItWasChanged) {
  EXPECT_EQ(login_status([] {}), 200);
  EXPECT_EQ(login_status([this] { set_password(kNew); }), 401);
  EXPECT_TRUE(accounts->tokens("eve", 1).empty());
}

TEST_F(LoginTest, APasswordBringsNoTokenOfANewAccountOfTheName) {
  const auto make_anew = [this] {
    ASSERT_TRUE(accounts->remove("eve"));
    ASSERT_TRUE(accounts->add({"eve", Role::developer, {}, hash_of(kOld), 2}));
  };
  EXPECT_EQ(login_status(make_anew), 401);
  EXPECT_EQ(login_status([this] { ASSERT_TRUE(accounts->remove("eve")); }), 401);
}

TEST_F(LoginTest, AnOldPasswordSetsNoNewOneAfterItWasChanged) {
  Request request = LoginTest::request({{"old", kOld}, {"password", "of who knows the old one"}});
  request.identity.account = "eve";
  const auto change_own = [&](Respond respond) {
    change_password(request, std::move(respond), *accounts, passwords, attempts);
  };
  EXPECT_EQ(status(change_own, [this] { set_password(kNew); }), 403);
  EXPECT_EQ(login_status([] {}), 401);
  set_password(kOld);
  EXPECT_EQ(status(change_own, [] {}), 200);
}

}  // namespace
}  // namespace race::server
