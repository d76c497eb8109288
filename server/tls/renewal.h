// CertificateRenewal: the certificate of a server that runs for longer than the certificate is good. It looks now and
// then whether one must be made; the authority that phones trust stays.
//
// Threads: any but its own, on which what is renewed is told.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "server/tls/authority.h"
#include "services/mutex.h"

namespace race::server {

class CertificateRenewal {
 public:
  /// What the certificate is for, and the one that is served now.
  struct Subject {
    Authority authority;
    std::vector<std::string> names;
    std::string chain;
  };
  /// Gets a new certificate, or why there is none: that is tried again.
  using Renewed = std::function<void(const Expected<ServerCertificate>&)>;
  /// `now`: seconds since 1970.
  struct Times {
    std::function<std::int64_t()> now;
    std::chrono::milliseconds period{std::chrono::hours(6)};  // between two looks
  };

  /// Throws std::system_error if there is no thread.
  CertificateRenewal(Subject subject, Times times, Renewed renewed);
  ~CertificateRenewal();
  CertificateRenewal(const CertificateRenewal&) = delete;
  CertificateRenewal& operator=(const CertificateRenewal&) = delete;

 private:
  void run() EXCLUDES(mutex_);
  void look();

  Subject subject_;
  const Times times_;
  const Renewed renewed_;
  services::Mutex mutex_;
  services::ConditionVariable ending_;
  bool ends_ GUARDED_BY(mutex_) = false;
  std::thread thread_;
};

}  // namespace race::server
