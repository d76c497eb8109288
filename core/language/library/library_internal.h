// Every function and method of the language, by file. Their parameters are in functions.cpp.
#pragma once

#include "core/language/library/functions.h"

namespace race::language::library {

/// The argument at `i`; unknown if it was not given.
inline const Value& optional(Arguments arguments, std::size_t i) {
  static const Value kAbsent = Value::unknown();
  return i < arguments.size() ? arguments[i] : kAbsent;
}
inline bool given(Arguments arguments, std::size_t i) { return !optional(arguments, i).is_unknown(); }

// builtins.cpp, conversions.cpp, iteration.cpp
Value absolute(Context&, Arguments);
Value all(Context&, Arguments);
Value any(Context&, Arguments);
Value to_bool(Context&, Arguments);
Value to_dict(Context&, Arguments);
Value enumerate(Context&, Arguments);
Value to_float(Context&, Arguments);
Value to_int(Context&, Arguments);
Value length(Context&, Arguments);
Value to_list(Context&, Arguments);
Value maximum(Context&, Arguments);
Value minimum(Context&, Arguments);
Value print(Context&, Arguments);
Value range(Context&, Arguments);
Value reversed(Context&, Arguments);
Value round_number(Context&, Arguments);
Value sorted(Context&, Arguments);
Value to_str(Context&, Arguments);
Value sum(Context&, Arguments);
Value zip(Context&, Arguments);

// math.cpp
Value math_acos(Context&, Arguments);
Value math_acosh(Context&, Arguments);
Value math_asin(Context&, Arguments);
Value math_asinh(Context&, Arguments);
Value math_atan(Context&, Arguments);
Value math_atan2(Context&, Arguments);
Value math_atanh(Context&, Arguments);
Value math_ceil(Context&, Arguments);
Value math_copysign(Context&, Arguments);
Value math_cos(Context&, Arguments);
Value math_cosh(Context&, Arguments);
Value math_degrees(Context&, Arguments);
Value math_exp(Context&, Arguments);
Value math_fabs(Context&, Arguments);
Value math_floor(Context&, Arguments);
Value math_fmod(Context&, Arguments);
Value math_hypot(Context&, Arguments);
Value math_isclose(Context&, Arguments);
Value math_isfinite(Context&, Arguments);
Value math_isinf(Context&, Arguments);
Value math_isnan(Context&, Arguments);
Value math_log(Context&, Arguments);
Value math_log10(Context&, Arguments);
Value math_log2(Context&, Arguments);
Value math_pow(Context&, Arguments);
Value math_radians(Context&, Arguments);
Value math_sin(Context&, Arguments);
Value math_sinh(Context&, Arguments);
Value math_sqrt(Context&, Arguments);
Value math_tan(Context&, Arguments);
Value math_tanh(Context&, Arguments);
Value math_trunc(Context&, Arguments);

// geo.cpp
Value geo_angle(Context&, Arguments);
Value geo_compose(Context&, Arguments);
Value geo_distance(Context&, Arguments);
Value geo_identity(Context&, Arguments);
Value geo_interpolate(Context&, Arguments);
Value geo_inverse(Context&, Arguments);
Value geo_mean(Context&, Arguments);
Value geo_offset(Context&, Arguments);
Value geo_pose(Context&, Arguments);
Value geo_rpy(Context&, Arguments);
Value geo_to_rpy(Context&, Arguments);
Value geo_transform(Context&, Arguments);

// string_methods.cpp, string_search.cpp, string_case.cpp
Value str_capitalize(Context&, const Value& self, Arguments);
Value str_center(Context&, const Value& self, Arguments);
Value str_count(Context&, const Value& self, Arguments);
Value str_endswith(Context&, const Value& self, Arguments);
Value str_find(Context&, const Value& self, Arguments);
Value str_index(Context&, const Value& self, Arguments);
Value str_isalnum(Context&, const Value& self, Arguments);
Value str_isalpha(Context&, const Value& self, Arguments);
Value str_isdigit(Context&, const Value& self, Arguments);
Value str_islower(Context&, const Value& self, Arguments);
Value str_isspace(Context&, const Value& self, Arguments);
Value str_isupper(Context&, const Value& self, Arguments);
Value str_join(Context&, const Value& self, Arguments);
Value str_ljust(Context&, const Value& self, Arguments);
Value str_lower(Context&, const Value& self, Arguments);
Value str_lstrip(Context&, const Value& self, Arguments);
Value str_partition(Context&, const Value& self, Arguments);
Value str_replace(Context&, const Value& self, Arguments);
Value str_rfind(Context&, const Value& self, Arguments);
Value str_rindex(Context&, const Value& self, Arguments);
Value str_rjust(Context&, const Value& self, Arguments);
Value str_rpartition(Context&, const Value& self, Arguments);
Value str_rsplit(Context&, const Value& self, Arguments);
Value str_rstrip(Context&, const Value& self, Arguments);
Value str_split(Context&, const Value& self, Arguments);
Value str_splitlines(Context&, const Value& self, Arguments);
Value str_startswith(Context&, const Value& self, Arguments);
Value str_strip(Context&, const Value& self, Arguments);
Value str_swapcase(Context&, const Value& self, Arguments);
Value str_title(Context&, const Value& self, Arguments);
Value str_upper(Context&, const Value& self, Arguments);
Value str_zfill(Context&, const Value& self, Arguments);

// list_methods.cpp
Value list_append(Context&, Value& self, Arguments);
Value list_clear(Context&, Value& self, Arguments);
Value list_count(Context&, const Value& self, Arguments);
Value list_extend(Context&, Value& self, Arguments);
Value list_index(Context&, const Value& self, Arguments);
Value list_insert(Context&, Value& self, Arguments);
Value list_pop(Context&, Value& self, Arguments);
Value list_remove(Context&, Value& self, Arguments);
Value list_reverse(Context&, Value& self, Arguments);
Value list_sort(Context&, Value& self, Arguments);
/// Sorts stably by <, in Python's order of equal elements when reversed; a type fault leaves the list as it was.
bool sort(Context& context, List& items, bool reverse);

// dict_methods.cpp
Value copied(Context&, const Value& self, Arguments);
Value dict_clear(Context&, Value& self, Arguments);
Value dict_get(Context&, const Value& self, Arguments);
Value dict_items(Context&, const Value& self, Arguments);
Value dict_keys(Context&, const Value& self, Arguments);
Value dict_pop(Context&, Value& self, Arguments);
Value dict_setdefault(Context&, Value& self, Arguments);
Value dict_update(Context&, Value& self, Arguments);
Value dict_values(Context&, const Value& self, Arguments);

}  // namespace race::language::library
