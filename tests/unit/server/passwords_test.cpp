#include "server/accounts/passwords.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>

namespace race::server {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr PasswordCost kCheap{1, 8192};  // the least that libsodium takes

Expected<std::string> hash(Passwords& passwords, const std::string& password) {
  std::promise<Expected<std::string>> done;
  passwords.hash(password, [&](Expected<std::string> hashed) { done.set_value(std::move(hashed)); });
  return done.get_future().get();
}

Expected<bool> compare(Passwords& passwords, const std::string& password, const std::string& hashed) {
  std::promise<Expected<bool>> done;
  passwords.compare(password, hashed, [&](Expected<bool> same) { done.set_value(std::move(same)); });
  return done.get_future().get();
}

TEST(Passwords, AreHashedWithArgon2idEachWithASaltOfItsOwn) {
  Passwords passwords(kCheap);
  const auto one = hash(passwords, "correct horse"), other = hash(passwords, "correct horse");
  EXPECT_THAT(one.value(), StartsWith("$argon2id$v=19$"));
  EXPECT_NE(one.value(), other.value());
  EXPECT_TRUE(compare(passwords, "correct horse", *one).value());
  EXPECT_TRUE(compare(passwords, "correct horse", *other).value());
  EXPECT_FALSE(compare(passwords, "correct horsf", *one).value());
  EXPECT_FALSE(compare(passwords, "", *one).value());
}

TEST(Passwords, CostSixtyFourMebibytesAndThreePassesUnlessTheySayOtherwise) {
  EXPECT_THAT(Passwords().hash_here("correct horse").value(), HasSubstr("$m=65536,t=3,p=1$"));
}

TEST(Passwords, NoPasswordIsThatOfAnAccountThatDoesNotExist) {
  Passwords passwords(kCheap);
  EXPECT_FALSE(compare(passwords, "", "").value());
  EXPECT_FALSE(compare(passwords, "correct horse", "").value());
  EXPECT_FALSE(compare(passwords, std::string(Passwords::kLongest + 1, '\0'), "").value());
  EXPECT_FALSE(compare(passwords, "correct horse", "no hash").value());
}

TEST(Passwords, HaveTenCharactersToTwoHundredBytesAndAreNotTheName) {
  const auto code = [](const std::string& password) {
    const auto fine = Passwords::check(password, "administrator");
    return fine ? "" : std::string(name(fine.error().code)) + ' ' + fine.error().path;
  };
  EXPECT_EQ(code("ninechars"), "out_of_range password");
  EXPECT_EQ(code("ten chars."), "");
  EXPECT_EQ(code("ääääääääää"), "");
  EXPECT_EQ(code("äääääääää"), "out_of_range password") << "nine characters, though 18 bytes";
  EXPECT_EQ(code(std::string(200, 'x')), "");
  EXPECT_EQ(code(std::string(201, 'x')), "out_of_range password");
  EXPECT_EQ(code("administrator"), "out_of_range password");
  EXPECT_EQ(code("abcdefghij\xff"), "out_of_range password");
}

TEST(Passwords, BeyondTheBoundNobodyWaits) {
  Passwords passwords(kCheap);
  std::promise<void> release;
  auto released = release.get_future().share();
  std::atomic<std::size_t> hashed{0}, refused{0};
  const auto ask = [&] {
    passwords.hash("correct horse", [&, released](const Expected<std::string>& done) {
      if (done) released.wait();
      ++(done ? hashed : refused);
      EXPECT_TRUE(done || done.error().code == ErrorCode::unavailable);
    });
  };
  for (std::size_t i = 0; i < Passwords::kMostWaiting + 3; ++i) ask();
  EXPECT_EQ(refused, 3U);
  release.set_value();
  while (hashed < Passwords::kMostWaiting) std::this_thread::yield();
  EXPECT_TRUE(hash(passwords, "again and again"));
}

}  // namespace
}  // namespace race::server
