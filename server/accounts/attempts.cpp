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
  const auto bucket = buckets.find(key);
  if (bucket == buckets.end()) return rate.burst;
  const std::chrono::duration<double, std::milli> since = now - bucket->second.at;
  return std::min(rate.burst, bucket->second.left + since.count() / static_cast<double>(rate.refill.count()));
}

std::optional<std::chrono::milliseconds> Attempts::wait(const std::string& address, const std::string& account,
                                                        Time now) {
  const services::MutexLock lock(mutex_);
  const auto longest = std::max(time_until_one(left(addresses_, address, kOfAddress, now), kOfAddress),
                                time_until_one(left(accounts_, account, kOfAccount, now), kOfAccount));
  if (longest.count() == 0) return std::nullopt;
  return longest;
}

// Full buckets are as good as none; if too many are not, the one that is nearest to it goes.
void Attempts::forget_full(Buckets& buckets, const Rate& rate, Time now) {
  if (buckets.size() < kMost) return;
  std::erase_if(buckets, [&](const auto& entry) { return left(buckets, entry.first, rate, now) >= rate.burst; });
  if (buckets.size() < kMost) return;
  buckets.erase(
      std::ranges::max_element(buckets, {}, [&](const auto& entry) { return left(buckets, entry.first, rate, now); }));
}

void Attempts::add(Buckets& buckets, const std::string& key, const Rate& rate, double failures, Time now) {
  const double rest = std::clamp(left(buckets, key, rate, now) - failures, 0.0, rate.burst);
  if (!buckets.contains(key)) forget_full(buckets, rate, now);
  buckets.insert_or_assign(key, Bucket{rest, now});
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
