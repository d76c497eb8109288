// A stored run as clients see it.
//
// Pure functions.
#pragma once

#include <vector>

#include "core/value/value.h"
#include "server/store/runs.h"

namespace race::server {

/// schemas/run.json
Value run_json(const RunRecord& run);

/// Sets `status`, and `outcome` or `fault`, as schemas/derivations.json has them.
void set_status(const RunRecord& run, Dict& json);

}  // namespace race::server
