#include "server/commands/call_arguments.h"

#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::server {
namespace {

bool is_json(const std::string& word) { return word.starts_with('{') || word.starts_with('['); }

Expected<Dict> read_named(std::span<const std::string> words) {
  Dict named;
  for (const std::string& word : words) {
    const std::size_t end = word.find('=');
    const std::string name = word.substr(0, end);
    if (end == std::string::npos || !is_name(name))
      return unexpected(ErrorCode::syntax, "must be NAME=VALUE, or all arguments one JSON object or list", word);
    if (named.find(Value(name))) return unexpected(ErrorCode::duplicate, quote(name) + " stands twice", word);
    const std::string text = word.substr(end + 1);
    auto value = parse_json(text);
    named.set(name, value ? std::move(*value) : Value(text));
  }
  return named;
}

}  // namespace

Expected<CalledOperation> read_operation(const std::string& text) {
  const std::size_t dot = text.rfind('.');
  if (dot == std::string::npos || dot == 0 || dot + 1 == text.size())
    return unexpected(ErrorCode::syntax, "must be SERVICE.OPERATION, such as robot.state; got " + quote(text),
                      "SERVICE.OPERATION");
  return CalledOperation{text.substr(0, dot), text.substr(dot + 1)};
}

Expected<void> read_call_arguments(std::span<const std::string> words, Dict& call) {
  if (words.size() == 1 && is_json(words.front())) {
    auto value = parse_json(words.front());
    if (!value) return unexpected(value.error().code, value.error().message, words.front());
    const char* const key = value->is_list() ? "args" : "kwargs";
    call.set(key, std::move(*value));
    return {};
  }
  ASSIGN_OR_RETURN(Dict named, read_named(words));
  if (!named.empty()) call.set("kwargs", std::move(named));
  return {};
}

}  // namespace race::server
