#include "server/control/held_operation.h"

#include <algorithm>

namespace race::server {

HeldOperation::Button& HeldOperation::button_of(const std::string& service) {
  const auto found = buttons_.find(service);
  if (found != buttons_.end()) return found->second;
  const auto heard = [](const auto& entry) { return entry.second.heard; };
  if (buttons_.size() >= kMostServices) buttons_.erase(std::ranges::min_element(buttons_, {}, heard));
  return buttons_[service];
}

bool HeldOperation::is_held_over(const std::string& service, std::uint64_t fence, Steady now) {
  Button& button = button_of(service);
  if (now - button.heard > Control::kSilence) button.fence = fence;
  button.heard = now;
  return button.fence != fence;
}

void HeldOperation::end(const std::string& service) {
  const auto found = buttons_.find(service);
  if (found == buttons_.end()) return;
  found->second.fence = 0;
  found->second.operation.clear();
}

bool HeldOperation::begins(const std::string& service, const std::string& operation, Steady now) {
  const bool begins = !goes_on(service, now) || button_of(service).operation != operation;
  Button& button = button_of(service);
  button.operation = operation;
  button.moved = now;
  return begins;
}

bool HeldOperation::goes_on(const std::string& service, Steady now) const {
  const auto found = buttons_.find(service);
  return found != buttons_.end() && !found->second.operation.empty() && now - found->second.moved <= kOneMotion;
}

}  // namespace race::server
