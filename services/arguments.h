// The arguments of a call by the names that an operation's parameters have.
#pragma once

#include "core/rsm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/component.h"

namespace race::services {

/// Binds positions and keywords to the parameters of `operation`; what is not given has its declared value, or is
/// absent if its type is optional. Errors, with the parameter's name as path: `missing`, `type` (not of the declared
/// TYPE, one argument too many, two for one parameter, or a name that is no parameter), `out_of_range` (outside of min
/// and max).
Expected<Dict> bind_arguments(const rsm::Operation& operation, const Call& call);

/// The operation of this name; nullptr if the service has none.
const rsm::Operation* find_operation(const rsm::Service& service, std::string_view name);

/// An Error as the error response of a call.
Value error_value(const Error& error);

}  // namespace race::services
