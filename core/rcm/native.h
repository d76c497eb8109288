// The codec of native models (schemas/native.json): the model as a document without links, oracles and `after`, and the
// origin of each of its elements. Pure functions.
#pragma once

#include <string>

#include "core/rcm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::rcm {

/// `native` as JSON, with the name and the services of `document`, which it is the translation of.
Value write_native(const Document& document, const NativeModel& native);

/// The inverse. `path` names the model in paths of errors, such as `header/native`. Errors: at `PATH/document` those of
/// read_document, `unknown_field` for a library, `oracle` for links, oracles and `after`; at `PATH/origin` `missing`
/// for an element of the model without origin, `unknown_name` for what is no element of it.
Checked<NativeModel> read_native(const Value& json, const std::string& path);

}  // namespace race::rcm
