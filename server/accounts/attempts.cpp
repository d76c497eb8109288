#include "server/accounts/attempts.h"

#include <algorithm>

namespace race::server {
namespace {

// One more failure needs one in the bucket.
std::chrono::milliseconds time_until_one(double left, const Attempts::Rate& rate) {
  const double missing = std::max(0.0, 1 - left);
  return std::chrono::milliseconds(static_cast<std::int64_t>(missing * static_cast<double>(rate.refill.count())));
}

// Addresses have no line feed.
std::string pair_of(const std::string& address, const std::string& account) { return address + '\n' + account; }

}  // namespace

double Attempts::left(const Buckets& buckets, const std::string& key, const Rate& rate, Time now) {
  const auto bucket = buckets.full.find(key);
  if (bucket == buckets.full.end() || bucket->second <= now) return rate.burst;
  const std::chrono::duration<double, std::milli> until_full = bucket->second - now;
  return rate.burst - until_full.count() / static_cast<double>(rate.refill.count());
}

void Attempts::forget(Buckets& buckets, const std::string& key) {
  const auto bucket = buckets.full.find(key);
  if (bucket == buckets.full.end()) return;
  buckets.by_time.erase({bucket->second, key});
  buckets.full.erase(bucket);
}

// Full buckets are as good as none; if too many are not, the one that is nearest to it goes.
void Attempts::add(Buckets& buckets, const std::string& key, const Rate& rate, double failures, Time now) {
  const double rest = std::clamp(left(buckets, key, rate, now) - failures, 0.0, rate.burst);
  forget(buckets, key);
  if (rest >= rate.burst) return;
  if (buckets.full.size() >= kMost) forget(buckets, std::string(buckets.by_time.begin()->second));
  const std::chrono::duration<double, std::milli> until_full{(rate.burst - rest) *
                                                             static_cast<double>(rate.refill.count())};
  const Time full = now + std::chrono::duration_cast<Time::duration>(until_full);
  buckets.full.emplace(key, full);
  buckets.by_time.emplace(full, key);
}

bool Attempts::is_known(const std::string& address, const std::string& account, Time now) const {
  return std::ranges::any_of(known_, [&](const Known& known) {
    return known.account == account && known.address == address && now - known.last <= kKnown;
  });
}

tl::expected<Attempts::Attempt, std::chrono::milliseconds> Attempts::begin(const std::string& address,
                                                                           const std::string& account, Time now) {
  const services::MutexLock lock(mutex_);
  if (account.empty()) return begin_at(address, now);
  const std::string pair = pair_of(address, account);
  const bool counts_for_account = !is_known(address, account, now);
  const auto own = std::max(time_until_one(left(addresses_, address, kOfAddress, now), kOfAddress),
                            time_until_one(left(pairs_, pair, kOfPair, now), kOfPair));
  if (own.count() > 0) return tl::unexpected(own);
  const auto of_account = time_until_one(left(accounts_, account, kOfAccount, now), kOfAccount);
  add(addresses_, address, kOfAddress, 1, now);
  if (counts_for_account && of_account.count() > 0) return tl::unexpected(of_account);
  add(pairs_, pair, kOfPair, 1, now);
  if (counts_for_account) add(accounts_, account, kOfAccount, 1, now);
  return Attempt{address, account, counts_for_account};
}

tl::expected<Attempts::Attempt, std::chrono::milliseconds> Attempts::begin_at(const std::string& address, Time now) {
  const auto wait = time_until_one(left(addresses_, address, kOfAddress, now), kOfAddress);
  if (wait.count() > 0) return tl::unexpected(wait);
  add(addresses_, address, kOfAddress, 1, now);
  return Attempt{address, "", false};
}

void Attempts::give_back(const Attempt& attempt, Time now) {
  add(addresses_, attempt.address, kOfAddress, -1, now);
  if (attempt.account.empty()) return;
  add(pairs_, pair_of(attempt.address, attempt.account), kOfPair, -1, now);
  if (attempt.counts_for_account) add(accounts_, attempt.account, kOfAccount, -1, now);
}

void Attempts::drop(const Attempt& attempt, Time now) {
  const services::MutexLock lock(mutex_);
  give_back(attempt, now);
}

void Attempts::succeed(const Attempt& attempt, Time now) {
  const services::MutexLock lock(mutex_);
  give_back(attempt, now);
  const auto is_of_account = [&](const Known& known) { return known.account == attempt.account; };
  std::erase_if(known_, [&](const Known& known) { return is_of_account(known) && known.address == attempt.address; });
  if (std::ranges::count_if(known_, is_of_account) >= std::ptrdiff_t{kMostKnown})
    known_.erase(std::ranges::find_if(known_, is_of_account));
  if (known_.size() >= kMostKnownOfAll) known_.pop_front();
  known_.push_back({attempt.account, attempt.address, now});
}

}  // namespace race::server
