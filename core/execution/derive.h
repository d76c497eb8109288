// `race derive`: texts in, derivations out. The whole way from a document and a script to what they mean.
#pragma once

#include <string_view>
#include <vector>

#include "core/execution/script.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::execution {

/// The derivation document of a model and a script (core/SEMANTICS.md section 7). Errors: every violation of the model
/// and of the script's services; nothing is derived then.
Checked<Value> derive_texts(std::string_view model, std::string_view script, OrderChoice order = {});

/// A script from its text (script.h). Its own codes, with an empty path: those of parse_json.
Checked<Script> read_script_text(std::string_view text);

/// {"errors": [{"path", "code", "message"}]}, the shape of every refusal; of more than kMaxErrors these alone, with
/// `more_errors`, which is true.
Value errors_json(const std::vector<Error>& errors);

}  // namespace race::execution
