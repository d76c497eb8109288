// Printing as Python does: str, repr, ascii, and the format specifications of f-strings.
#pragma once

#include <string>
#include <string_view>

#include "core/language/values/context.h"
#include "core/value/value.h"

namespace race::language {

/// str(v): a string as it is, all else as repr.
std::string str(const Value& v);
/// repr(v): strings in quotes, escapes where Python has them.
std::string repr(const Value& v);
/// Takes what str(v) and repr(v) cost off the budget; false and a fault if that is not enough.
bool charge_printing(Context& context, const Value& v);
/// `text` with everything that is not ASCII escaped.
std::string ascii(std::string_view text);

/// format(v, specification): [[fill]align][sign][z][#][0][width][,|_][.precision][type]. A bad one is a `value` fault,
/// one that does not fit the type of v too.
Value formatted(Context& context, const Value& v, std::string_view specification);

}  // namespace race::language
