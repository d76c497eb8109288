#include "server/accounts/pairings.h"

#include <algorithm>
#include <utility>

#include "server/accounts/secret.h"

namespace race::server {

// The share first: who has used it up waits for their own codes.
std::optional<Pairings::Full> Pairings::full(std::string_view account, Time now) const {
  std::size_t own = 0;
  Time first = Time::max(), first_own = Time::max();
  for (const auto& [digest, entry] : pairings_) {
    first = std::min(first, entry.until);
    if (entry.pairing.by.account != account) continue;
    ++own;
    first_own = std::min(first_own, entry.until);
  }
  const auto until = [now](Time time) { return std::chrono::ceil<std::chrono::milliseconds>(time - now); };
  if (own >= kMostOfAccount) return Full{kMostOfAccount, true, until(first_own)};
  if (pairings_.size() >= kMost) return Full{kMost, false, until(first)};
  return std::nullopt;
}

tl::expected<std::string, Pairings::Full> Pairings::issue(Pairing pairing, Time now) {
  std::string code = make_code();
  const services::MutexLock lock(mutex_);
  const auto is_of_login = [&](const Identity& by) {
    return by.account == pairing.by.account && by.token == pairing.by.token;
  };
  std::erase_if(pairings_,
                [&](const auto& entry) { return entry.second.until <= now || is_of_login(entry.second.pairing.by); });
  if (const auto too_many = full(pairing.by.account, now)) return tl::unexpected(*too_many);
  pairings_.emplace(digest_of_secret(code), Entry{std::move(pairing), now + kLife});
  return code;
}

std::optional<Pairing> Pairings::take(std::string_view code, Time now) {
  const std::string digest = digest_of_secret(code.size() == kCodeLength ? code : std::string_view());
  const services::MutexLock lock(mutex_);
  auto found = pairings_.extract(digest);
  if (!found || found.mapped().until <= now) return std::nullopt;
  return std::move(found.mapped().pairing);
}

}  // namespace race::server
