// Fields: reads and validates a JSON object field by field. A field that is missing, of the wrong type, out of range or
// unknown becomes a violation. Its path is that of the element that the object describes, or of the field itself
// (Paths). Reading continues, so that violations are listed at once (error_list.h). Used for one object, on one thread;
// borrows the object and the list of violations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race {

/// Whether `text` matches [A-Za-z_][A-Za-z0-9_]*, as every name of a document does.
bool is_name(std::string_view text);

/// Whether a number in `value`, at any level, is out of the range of int64 or double (parse_json's unknown value) or
/// not finite.
bool has_number_out_of_range(const Value& value);

/// Whether lists and dicts in `value` are nested more than `levels` deep.
bool deeper_than(const Value& value, std::size_t levels);

class Fields {
 public:
  enum class Need { required, optional };
  /// What the path of a violation names: the element, `Root/A` (documents), or the field that it is about, `when`
  /// (bodies of requests).
  enum class Paths { element, field };

  /// `what` names the element in messages, such as "port `done`". If `json` is no object, that is a violation (`type`)
  /// and the object counts as empty, without violations for missing fields.
  Fields(const Value& json, std::string path, std::string what, std::vector<Error>& errors,
         Paths paths = Paths::element);
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  bool is_object() const { return is_object_; }
  const std::string& path() const { return path_; }
  /// Of the object, or of its field `key`.
  void violation(ErrorCode code, std::string message, std::string_view key = {});

  /// The value of `key` (nullptr if absent); marks the field as known. A required one that is absent is a violation.
  const Value* find(std::string_view key, Need need = Need::optional);
  /// A string; nothing if it is absent or of another type.
  std::optional<std::string> text(std::string_view key, Need need = Need::optional);
  std::optional<bool> boolean(std::string_view key);
  /// A whole number from `least` to `most`; nothing (a violation, `out_of_range` if it is another one) otherwise.
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t least, std::int64_t most,
                                      Need need = Need::optional);
  /// An int or a double, as a double.
  std::optional<double> number(std::string_view key);
  /// The items of a list; empty if it is absent or of another type.
  const List& list(std::string_view key, Need need = Need::optional);
  /// The items of a list of strings; others are violations and left out.
  std::vector<std::string> texts(std::string_view key, Need need = Need::optional);
  /// Any JSON; a number out of range is a violation (`constant`).
  std::optional<Value> constant(std::string_view key, Need need = Need::optional);

  /// Every field that was not read is a violation (`unknown_field`).
  void close();

 private:
  void wrong_type(std::string_view key, std::string_view expected, const Value& value);

  const Dict* fields_;
  bool is_object_;
  std::string path_, what_;
  Paths paths_;
  std::vector<Error>& errors_;
  std::vector<std::string_view> known_;
};

inline constexpr auto kRequired = Fields::Need::required;
inline constexpr auto kByField = Fields::Paths::field;

/// "a list", "a string" and so on, for messages.
std::string_view kind_name(const Value& value);

}  // namespace race
