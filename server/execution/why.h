// Why a port fired or does not fire, as schemas/why.json; and a fault, as in schemas/core.json.
#pragma once

#include "core/semantics/run.h"
#include "core/value/value.h"

namespace race::server {

/// Of a run as it stands.
Value why_json(semantics::Run& run, semantics::PortId port);

/// The results of the root that are set.
Value root_results(const semantics::Run& run);

/// {"kind", "at", "message"}
Value fault_json(const semantics::RunFault& fault);

}  // namespace race::server
