// The RSM codec: a service's description (core/SEMANTICS.md, section 1) from JSON, with every violation of the format
// and of Definitions 4.1 to 4.3 listed, and back. Pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/rsm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::rsm {

/// Reads a service, or an interface (operations and events alone), from JSON. `rsm` and `name` may be absent, as in
/// a script, where the service has a key. Every violation has the path `path`, such as `services/robot`; codes:
/// `version`, `type`, `missing`, `unknown_field`, `constant`, and those of violations().
Checked<Service> read_service(const Value& json, const std::string& path);

/// As read_service, from a text; codes `json`, `too_deep`, `too_large` as well.
Checked<Service> read_service_text(std::string_view text, const std::string& path);

/// The constraints of Definitions 4.1 to 4.3 that `service` breaks: `name`, `duplicate` (names of operations and events
/// are distinct), `missing` (a service with states needs `init`), `reference`.
std::vector<Error> violations(const Service& service, const std::string& path);

/// The JSON of a service, fields in the order of the format; what is empty or default is left out.
Value write_service(const Service& service);

}  // namespace race::rsm
