// The checker: whether a text is code of the function language and of the state whose names it uses.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/language/interface/symbols.h"
#include "core/value/expected.h"

namespace race::language {

/// The violations of `text` as code of a state with these names: `syntax`, `forbidden`, `scope`, `effect`,
/// `service_call`, `unknown_name`; of one code not more than fill a list (error_list.h). Empty = it compiles. Paths are
/// left to the caller.
std::vector<Error> check(std::string_view text, CodeKind kind, const Symbols& symbols);

/// The names after `var.` in `text`, declared or not. Empty for code that does not parse.
std::vector<std::string> variable_names(std::string_view text);

}  // namespace race::language
