// Why a port fired or does not fire, as schemas/why.json.
#pragma once

#include "core/execution/execution.h"

namespace race::execution {

/// Of an execution as it stands.
Value why_json(Execution& execution, semantics::PortId port);

}  // namespace race::execution
