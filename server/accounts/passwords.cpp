#include "server/accounts/passwords.h"

#include <sodium.h>

#include <array>
#include <memory>
#include <utility>

#include "core/language/primitives/utf8.h"

namespace race::server {
namespace {

tl::unexpected<Error> busy() { return unexpected(ErrorCode::unavailable, "too many passwords are being checked"); }

}  // namespace

Expected<void> Passwords::check(const std::string& password, const std::string& account) {
  const auto wrong = [](const std::string& why) { return unexpected(ErrorCode::out_of_range, why, "password"); };
  if (password.size() > kLongest) return wrong("a password has at most " + std::to_string(kLongest) + " bytes");
  if (!language::utf8::valid(password)) return wrong("a password is UTF-8");
  if (language::utf8::length(password) < kShortest)
    return wrong("a password has at least " + std::to_string(kShortest) + " characters");
  if (password == account) return wrong("a password is not the name of its account");
  return {};
}

Expected<std::string> Passwords::hash_here(const std::string& password) const {
  std::array<char, crypto_pwhash_STRBYTES> text{};
  const int failed = crypto_pwhash_str_alg(text.data(), password.data(), password.size(), cost_.passes, cost_.bytes,
                                           crypto_pwhash_ALG_ARGON2ID13);
  if (failed != 0) return unexpected(ErrorCode::unavailable, "there is no memory to hash a password");
  return std::string(text.data());
}

bool Passwords::post(std::function<void()> work) {
  if (waiting_.fetch_add(1) >= kMostWaiting) {
    --waiting_;
    return false;
  }
  const bool posted = pool_.post([this, work = std::move(work)] {
    work();
    --waiting_;
  });
  if (!posted) --waiting_;
  return posted;
}

void Passwords::hash(std::string password, Hashed hashed) {
  const auto done = std::make_shared<Hashed>(std::move(hashed));
  const bool posted = post([this, password = std::move(password), done] { (*done)(hash_here(password)); });
  if (!posted) (*done)(busy());
}

// Made once, of a password that nobody can give.
const std::string& Passwords::hash_of_nothing() {
  if (hash_of_nothing_.empty()) hash_of_nothing_ = hash_here(std::string(kLongest + 1, '\0')).value_or("");
  return hash_of_nothing_;
}

void Passwords::compare(std::string password, std::string hash, Compared compared) {
  const auto done = std::make_shared<Compared>(std::move(compared));
  const bool posted = post([this, password = std::move(password), hash = std::move(hash), done] {
    const std::string& stored = hash.empty() ? hash_of_nothing() : hash;
    const bool same = crypto_pwhash_str_verify(stored.c_str(), password.data(), password.size()) == 0;
    (*done)(same && !hash.empty());
  });
  if (!posted) (*done)(busy());
}

}  // namespace race::server
