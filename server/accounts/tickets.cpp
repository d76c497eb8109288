#include "server/accounts/tickets.h"

#include <algorithm>
#include <utility>

#include "server/accounts/secret.h"

namespace race::server {

void Tickets::forget_old(Time now) {
  std::erase_if(tickets_, [&](const auto& entry) { return entry.second.until <= now; });
  while (tickets_.size() >= kMost)
    tickets_.erase(std::ranges::min_element(tickets_, {}, [](const auto& entry) { return entry.second.until; }));
}

std::string Tickets::issue(Identity identity, Time now) {
  std::string ticket = make_secret(kTicketPrefix);
  const services::MutexLock lock(mutex_);
  forget_old(now);
  tickets_.insert_or_assign(digest_of_secret(ticket), Entry{std::move(identity), now + kLife});
  return ticket;
}

std::optional<Identity> Tickets::take(std::string_view ticket, Time now) {
  const services::MutexLock lock(mutex_);
  const auto found = tickets_.find(digest_of_secret(ticket));
  if (found == tickets_.end()) return std::nullopt;
  const Entry entry = std::move(found->second);
  tickets_.erase(found);
  if (entry.until <= now) return std::nullopt;
  return entry.identity;
}

}  // namespace race::server
