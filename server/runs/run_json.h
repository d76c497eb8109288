// A stored run and its samples as clients see them.
//
// Pure functions.
#pragma once

#include <vector>

#include "core/value/value.h"
#include "server/store/runs.h"
#include "server/store/samples.h"

namespace race::server {

/// schemas/run.json
Value run_json(const RunRecord& run);

/// Sets `status`, and `outcome` or `fault`, as schemas/derivations.json has them.
void set_status(const RunRecord& run, Dict& json);

/// The items of schemas/samples.json.
List samples_json(const std::vector<Sample>& samples);

}  // namespace race::server
