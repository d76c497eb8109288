// The skills of a document (api/skills.md), as a model reads them. Pure.
#pragma once

#include <string>

#include "core/value/value.h"

namespace race::server::mcp {

/// The library states of a document that are marked as skills: `document`, `skill` (the state to link), title,
/// description, category, parameters with units and ranges, results, and ports; one with `advice` is an error. A draft
/// of any shape is read; what is not of the form is left out.
List skills_of(const std::string& name, const Value& document);

}  // namespace race::server::mcp
