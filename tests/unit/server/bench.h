// What tests of the server hand to a Host whose news nobody wants.
#pragma once

#include "services/host/host.h"

namespace race::server {

struct NoObserver final : services::HostObserver {
  void delivered(const services::Delivery&) override {}
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string&) override {}
};

}  // namespace race::server
