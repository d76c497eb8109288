// The scope of a state: the names that its code may use (core/SEMANTICS.md section 2), and conditions that somebody who
// watches a run evaluates in it.
#pragma once

#include <string_view>

#include "core/language/interface/symbols.h"
#include "core/semantics/program.h"

namespace race::semantics {

/// The names of the scope of `s`, each with its place in Δ.
language::Symbols symbols_of(const Program& program, StateId s);

/// A condition in the scope of `s` that is no part of the program, for Run::truth. Errors, without paths: those of
/// language::check; `unknown_name`: it reads data of a service that the model does not read, so runs do not keep it.
Checked<Code> compile_condition(const Program& program, StateId s, std::string_view text);

}  // namespace race::semantics
