#include "server/control/held_operation.h"

namespace race::server {

bool HeldOperation::is_held_over(const std::string& service, std::uint64_t fence, Steady now) {
  if (heard_from_ != service || now - heard_ > Control::kSilence) fence_ = fence;
  heard_from_ = service;
  heard_ = now;
  return fence_ != fence;
}

bool HeldOperation::begins(const std::string& service, const std::string& operation, Steady now) {
  const bool begins = operation_ != operation || !goes_on(service, now);
  service_ = service;
  operation_ = operation;
  moved_ = now;
  return begins;
}

bool HeldOperation::goes_on(const std::string& service, Steady now) const {
  return service_ == service && now - moved_ <= kOneMotion;
}

}  // namespace race::server
