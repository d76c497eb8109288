// A stored run, its samples and its pictures as clients see them.
//
// Pure functions.
#pragma once

#include <vector>

#include "core/value/value.h"
#include "server/store/pictures.h"
#include "server/store/runs.h"
#include "server/store/samples.h"

namespace race::server {

/// schemas/run.json
Value run_json(const RunRecord& run);

/// Sets `status`, and `outcome` or `fault`, as schemas/derivations.json has them.
void set_status(const RunRecord& run, Dict& json);

/// schemas/run_picture.json; without `jpeg` if it is empty.
Dict picture_json(const Picture& picture);

/// The items of schemas/samples.json.
List samples_json(const std::vector<Sample>& samples);

}  // namespace race::server
