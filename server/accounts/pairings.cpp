#include "server/accounts/pairings.h"

#include <algorithm>
#include <utility>

#include "server/accounts/secret.h"

namespace race::server {

tl::expected<std::string, std::chrono::milliseconds> Pairings::issue(Pairing pairing, Time now) {
  std::string code = make_code();
  const services::MutexLock lock(mutex_);
  std::erase_if(pairings_, [&](const auto& entry) { return entry.second.until <= now; });
  if (pairings_.size() >= kMost) {
    const auto first = std::ranges::min_element(pairings_, {}, [](const auto& entry) { return entry.second.until; });
    return tl::unexpected(std::chrono::ceil<std::chrono::milliseconds>(first->second.until - now));
  }
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
