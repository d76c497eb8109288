// A service as watchers see it.
#pragma once

#include "core/value/value.h"
#include "services/host/host.h"

namespace race::server {

/// schemas/service_state.json
Value service_state_json(const services::ServiceStatus& status);
/// An item of schemas/services.json: the same with type and RSM.
Value service_json(const services::ServiceStatus& status);

}  // namespace race::server
