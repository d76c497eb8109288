// The tables of functions, methods and constants.
#include "core/language/library/functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/language/library/library_internal.h"

namespace race::language {
namespace {

using namespace library;

constexpr std::array kBuiltins = {
    Function{"abs", "x", absolute},
    Function{"all", "iterable", all},
    Function{"any", "iterable", any},
    Function{"bool", "x?", to_bool},
    Function{"dict", "x? *", to_dict},
    Function{"enumerate", "iterable= start?=", enumerate},
    Function{"float", "x?", to_float},
    Function{"int", "x? base?=", to_int},
    Function{"len", "x", length},
    Function{"list", "iterable?", to_list},
    Function{"log", "sep! end! *", print},
    Function{"max", "default! *", maximum},
    Function{"min", "default! *", minimum},
    Function{"print", "sep! end! *", print},
    Function{"range", "start stop? step?", range},
    Function{"reversed", "sequence", reversed},
    Function{"round", "number= ndigits?=", round_number, 16},
    Function{"sorted", "iterable reverse!", sorted},
    Function{"str", "object?=", to_str},
    Function{"sum", "iterable start?=", sum},
    Function{"zip", "*", zip},
};

constexpr std::array kMath = {
    Function{"acos", "x", math_acos},
    Function{"acosh", "x", math_acosh},
    Function{"asin", "x", math_asin},
    Function{"asinh", "x", math_asinh},
    Function{"atan", "x", math_atan},
    Function{"atan2", "y x", math_atan2},
    Function{"atanh", "x", math_atanh},
    Function{"ceil", "x", math_ceil},
    Function{"copysign", "x y", math_copysign},
    Function{"cos", "x", math_cos},
    Function{"cosh", "x", math_cosh},
    Function{"degrees", "x", math_degrees},
    Function{"exp", "x", math_exp},
    Function{"fabs", "x", math_fabs},
    Function{"floor", "x", math_floor},
    Function{"fmod", "x y", math_fmod},
    Function{"hypot", "*", math_hypot},
    Function{"isclose", "a= b= rel_tol! abs_tol!", math_isclose},
    Function{"isfinite", "x", math_isfinite},
    Function{"isinf", "x", math_isinf},
    Function{"isnan", "x", math_isnan},
    Function{"log", "x base?", math_log},
    Function{"log10", "x", math_log10},
    Function{"log2", "x", math_log2},
    Function{"pow", "x y", math_pow},
    Function{"radians", "x", math_radians},
    Function{"sin", "x", math_sin},
    Function{"sinh", "x", math_sinh},
    Function{"sqrt", "x", math_sqrt},
    Function{"tan", "x", math_tan},
    Function{"tanh", "x", math_tanh},
    Function{"trunc", "x", math_trunc},
};

constexpr std::array kGeo = {
    Function{"angle", "a= b=", geo_angle, 16},
    Function{"compose", "a= b=", geo_compose, 64},
    Function{"distance", "a= b=", geo_distance, 16},
    Function{"identity", "", geo_identity, 32},
    Function{"interpolate", "a= b= s=", geo_interpolate, 64},
    Function{"inverse", "a=", geo_inverse, 64},
    Function{"mean", "poses=", geo_mean, 64},
    Function{"offset", "pose= x= y= z=", geo_offset, 64},
    Function{"pose", "position= orientation=", geo_pose, 32},
    Function{"rpy", "r= p= y=", geo_rpy, 32},
    Function{"to_rpy", "pose=", geo_to_rpy, 32},
    Function{"transform", "a= point=", geo_transform, 32},
};

// Of a method; signature() reads the same text for functions.
constexpr Method::Overload overload(std::string_view parameters) {
  Method::Overload made{.parameters = parameters};
  while (!parameters.empty()) {
    const std::string_view word = parameters.substr(0, parameters.find(' '));
    parameters.remove_prefix(std::min(word.size() + 1, parameters.size()));
    ++made.most;
    if (word.find_first_of("?!") == word.npos) ++made.required;
  }
  return made;
}
constexpr Method::Overload reads(std::string_view parameters, Value (*compute)(Context&, const Value&, Arguments)) {
  Method::Overload made = overload(parameters);
  made.compute = compute;
  return made;
}
constexpr Method::Overload writes(std::string_view parameters, Value (*mutate)(Context&, Value&, Arguments)) {
  Method::Overload made = overload(parameters);
  made.mutate = mutate;
  return made;
}
constexpr Method::Overload kNo = {};

constexpr Method text(std::string_view name, std::string_view parameters,
                      Value (*compute)(Context&, const Value&, Arguments)) {
  return {name, reads(parameters, compute), kNo, kNo};
}

constexpr std::array kMethods = {
    text("capitalize", "", str_capitalize),
    text("center", "width fill?", str_center),
    text("endswith", "suffix start? end?", str_endswith),
    text("find", "sub start? end?", str_find),
    text("isalnum", "", str_isalnum),
    text("isalpha", "", str_isalpha),
    text("isdigit", "", str_isdigit),
    text("islower", "", str_islower),
    text("isspace", "", str_isspace),
    text("isupper", "", str_isupper),
    text("join", "iterable", str_join),
    text("ljust", "width fill?", str_ljust),
    text("lower", "", str_lower),
    text("lstrip", "chars?", str_lstrip),
    text("partition", "sep", str_partition),
    text("replace", "old new count?", str_replace),
    text("rfind", "sub start? end?", str_rfind),
    text("rindex", "sub start? end?", str_rindex),
    text("rjust", "width fill?", str_rjust),
    text("rpartition", "sep", str_rpartition),
    text("rsplit", "sep?= maxsplit?=", str_rsplit),
    text("rstrip", "chars?", str_rstrip),
    text("split", "sep?= maxsplit?=", str_split),
    text("splitlines", "keepends?=", str_splitlines),
    text("startswith", "prefix start? end?", str_startswith),
    text("strip", "chars?", str_strip),
    text("swapcase", "", str_swapcase),
    text("title", "", str_title),
    text("upper", "", str_upper),
    text("zfill", "width", str_zfill),
    Method{"count", reads("sub start? end?", str_count), reads("x", list_count), kNo},
    Method{"index", reads("sub start? end?", str_index), reads("x start? end?", list_index), kNo},
    Method{"append", kNo, writes("x", list_append), kNo},
    Method{"clear", kNo, writes("", list_clear), writes("", dict_clear)},
    Method{"copy", kNo, reads("", copied), reads("", copied)},
    Method{"extend", kNo, writes("iterable", list_extend), kNo},
    Method{"get", kNo, kNo, reads("key default?", dict_get)},
    Method{"insert", kNo, writes("i x", list_insert), kNo},
    Method{"items", kNo, kNo, reads("", dict_items)},
    Method{"keys", kNo, kNo, reads("", dict_keys)},
    Method{"pop", kNo, writes("i?", list_pop), writes("key default?", dict_pop)},
    Method{"remove", kNo, writes("x", list_remove), kNo},
    Method{"reverse", kNo, writes("", list_reverse), kNo},
    Method{"setdefault", kNo, kNo, writes("key default?", dict_setdefault)},
    Method{"sort", kNo, writes("reverse!", list_sort), kNo},
    Method{"update", kNo, kNo, writes("other", dict_update)},
    Method{"values", kNo, kNo, reads("", dict_values)},
};

template <typename Table>
auto find_in(const Table& table, std::string_view name) -> decltype(table.data()) {
  for (const auto& entry : table)
    if (entry.name == name) return &entry;
  return nullptr;
}

}  // namespace

const Method::Overload* Method::overload(Value::Kind kind) const {
  const Overload& found = kind == Value::Kind::string ? string : kind == Value::Kind::list ? list : dict;
  const bool has_methods = kind == Value::Kind::string || kind == Value::Kind::list || kind == Value::Kind::dict;
  return has_methods && found ? &found : nullptr;
}

std::string_view Method::parameters() const {
  return string ? string.parameters : list ? list.parameters : dict.parameters;
}

const Function* find_function(std::string_view module, std::string_view name) {
  if (module.empty()) return find_in(kBuiltins, name);
  if (module == "math") return find_in(kMath, name);
  return module == "geo" ? find_in(kGeo, name) : nullptr;
}

const Method* find_method(std::string_view name) { return find_in(kMethods, name); }

const Value* find_constant(std::string_view module, std::string_view name) {
  static const std::array<std::pair<std::string_view, Value>, 5> kConstants = {
      {{"pi", Value(3.141592653589793)},
       {"e", Value(2.718281828459045)},
       {"tau", Value(6.283185307179586)},
       {"inf", Value(std::numeric_limits<double>::infinity())},
       {"nan", Value(std::numeric_limits<double>::quiet_NaN())}}};
  if (module != "math") return nullptr;
  for (const auto& [known, value] : kConstants)
    if (known == name) return &value;
  return nullptr;
}

bool is_builtin(std::string_view name) { return name == "available" || find_function("", name) != nullptr; }
bool is_module(std::string_view name) { return name == "math" || name == "geo"; }

Signature signature(std::string_view text) {
  Signature made;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (word == "*") {
      made.variadic = true;
      continue;
    }
    Signature::Parameter p;
    p.name = word.substr(0, word.find_first_of("?=!"));
    p.positional = word.find('!') == word.npos;
    p.required = p.positional && word.find('?') == word.npos;
    p.by_name = word.find_first_of("=!") != word.npos;
    made.parameters.push_back(p);
  }
  return made;
}

}  // namespace race::language
