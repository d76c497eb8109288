#include "server/tls/renewal.h"

#include <utility>

#include "services/failures.h"
#include "services/thread_name.h"

namespace race::server {

CertificateRenewal::CertificateRenewal(Subject subject, Times times, Renewed renewed)
    : subject_(std::move(subject)),
      times_(std::move(times)),
      renewed_(std::move(renewed)),
      thread_([this] { run(); }) {}

CertificateRenewal::~CertificateRenewal() {
  {
    const services::MutexLock lock(mutex_);
    ends_ = true;
  }
  ending_.notify_all();
  thread_.join();
}

void CertificateRenewal::run() {
  services::name_thread("certificates");
  for (;;) {
    {
      const services::MutexLock lock(mutex_);
      if (ending_.wait_for(mutex_, times_.period, [this]() REQUIRES(mutex_) { return ends_; })) return;
    }
    services::run_reporting("the renewal of the certificate", [this] { look(); });
  }
}

void CertificateRenewal::look() {
  const auto certificate = subject_.authority.certificate_for(subject_.names, times_.now());
  if (certificate && certificate->chain == subject_.chain) return;
  renewed_(certificate);
  if (certificate) subject_.chain = certificate->chain;
}

}  // namespace race::server
