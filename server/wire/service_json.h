// Services as clients see them.
#pragma once

#include "core/value/value.h"
#include "services/host/host.h"

namespace race::server {

/// schemas/service_state.json
Value service_state_json(const services::ServiceStatus& status);
/// schemas/services.json, frozen: state, type and RSM of each.
Value services_json(const std::vector<services::ServiceStatus>& services);

}  // namespace race::server
