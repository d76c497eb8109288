#include "server/accounts/attempts.h"

#include <algorithm>

namespace race::server {
namespace {

// One more failure needs one in the bucket.
std::chrono::milliseconds time_until_one(double left, const Attempts::Rate& rate) {
  const double missing = std::max(0.0, 1 - left);
  return std::chrono::milliseconds(static_cast<std::int64_t>(missing * static_cast<double>(rate.refill.count())));
}

}  // namespace

double Attempts::left(const Buckets& buckets, const std::string& key, const Rate& rate, Time now) {
  const auto bucket = buckets.full.find(key);
  if (bucket == buckets.full.end() || bucket->second <= now) return rate.burst;
  const std::chrono::duration<double, std::milli> until_full = bucket->second - now;
  return rate.burst - until_full.count() / static_cast<double>(rate.refill.count());
}

std::optional<std::chrono::milliseconds> Attempts::wait(const std::string& address, const std::string& account,
                                                        Time now) {
  const services::MutexLock lock(mutex_);
  const auto longest = std::max(time_until_one(left(addresses_, address, kOfAddress, now), kOfAddress),
                                time_until_one(left(accounts_, account, kOfAccount, now), kOfAccount));
  if (longest.count() == 0) return std::nullopt;
  return longest;
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

void Attempts::begun(const std::string& address, const std::string& account, Time now) {
  const services::MutexLock lock(mutex_);
  add(addresses_, address, kOfAddress, 1, now);
  add(accounts_, account, kOfAccount, 1, now);
}

void Attempts::not_failed(const std::string& address, const std::string& account, Time now) {
  const services::MutexLock lock(mutex_);
  add(addresses_, address, kOfAddress, -1, now);
  add(accounts_, account, kOfAccount, -1, now);
}

}  // namespace race::server
